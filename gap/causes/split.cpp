#include "gap/causes/split.h"

#include <algorithm>

namespace gap {

namespace {

constexpr int kFitFrames = 5;
constexpr int kRefineFrames = 16, kLeastRefineFrames = 8;
constexpr int kRefineFramesInAll = 64;  // of all samples: more of them need fewer frames each to tell as much
constexpr int kJudgeFrames = 16;

Split withRefined(Split split) {
  const auto samples = static_cast<int>(std::max<std::size_t>(1, split.fitted.samples.size()));
  split.refined = split.fitted;
  split.refined.most_frames = std::clamp(kRefineFramesInAll / samples, kLeastRefineFrames, kRefineFrames);
  return split;
}

}  // namespace

Split splitOf(const Replay& replay, std::uint64_t seed) {
  Split split;
  split.fitted = {.samples = {}, .part = {}, .most_frames = kFitFrames, .seed = seed};
  split.held_out = {.samples = {}, .part = {}, .most_frames = kJudgeFrames, .seed = seed};
  const auto& samples = replay.samples();
  for (std::size_t s = 0; s < samples.size(); ++s) {
    (samples[s].sample->role == model::Role::kPrediction ? split.held_out : split.fitted).samples.push_back(s);
  }
  if (!split.held_out.samples.empty() && !split.fitted.samples.empty()) return withRefined(split);
  const std::vector<SetUp> setups = setupsOf(replay);
  if (setups.size() < 3) return splitByBeams(replay, seed);
  split.held_out.samples.clear();
  split.fitted.samples.clear();
  for (std::size_t i = 0; i < setups.size(); ++i) {
    std::vector<std::size_t>& part = (i % 3 == 1 ? split.held_out : split.fitted).samples;
    part.insert(part.end(), setups[i].samples.begin(), setups[i].samples.end());
  }
  std::sort(split.held_out.samples.begin(), split.held_out.samples.end());
  std::sort(split.fitted.samples.begin(), split.fitted.samples.end());
  return withRefined(split);
}

Split splitByBeams(const Replay& replay, std::uint64_t seed) {
  Split split;
  const bool pooled = replay.samples().front().layout->pooled();
  split.fitted = {.samples = {}, .part = {pooled ? Half::kAll : Half::kEven}, .most_frames = kFitFrames, .seed = seed};
  split.held_out = {
      .samples = {}, .part = {pooled ? Half::kAll : Half::kOdd}, .most_frames = kJudgeFrames, .seed = seed};
  for (std::size_t s = 0; s < replay.samples().size(); ++s) {
    split.fitted.samples.push_back(s);
    split.held_out.samples.push_back(s);
  }
  split.weak = true;
  return withRefined(split);
}

}  // namespace gap
