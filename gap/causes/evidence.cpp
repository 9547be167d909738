#include "gap/causes/evidence.h"

#include <algorithm>

#include "gap/distance/settle.h"

namespace gap {

namespace {

/// How many frames are simulated of a sample.
int simulatedFrames(const Evidence& evidence, const ReplaySample& sample) {
  const auto affordable = static_cast<int>(evidence.most_shots / std::max<std::size_t>(1, sample.beams.size()));
  return std::min({evidence.most_frames, std::max(3, sample.frames), std::max(3, affordable)});
}

std::vector<Comparison> comparisonsOf(const Replay& replay, const World& world, const Evidence& evidence) {
  std::vector<Comparison> comparisons;
  for (const std::size_t s : evidence.samples) {
    const ReplaySample& sample = replay.samples()[s];
    const int frames = simulatedFrames(evidence, sample);
    comparisons.push_back(
        {s, sample.statistics, sample.frames, replay.simulate(world, s, frames, evidence.seed), frames});
  }
  return comparisons;
}

double total(const Replay& replay, const World& world, std::vector<Comparison>& comparisons, Part part) {
  const double settling = settle(replay, world, comparisons, part);
  return settling + discrepancy(replay, comparisons, part);
}

}  // namespace

Evidence spreadOver(const Evidence& evidence, std::size_t most_samples, int most_frames) {
  Evidence few = evidence;
  few.most_frames = most_frames;
  if (evidence.samples.size() <= most_samples) return few;
  few.samples.clear();
  for (std::size_t i = 0; i < most_samples; ++i) {
    few.samples.push_back(evidence.samples[i * (evidence.samples.size() - 1) / (most_samples - 1)]);
  }
  return few;
}

World worldOf(const Replay& replay, const Hypothesis& hypothesis, const std::vector<double>& values) {
  World world = replay.baseline();
  hypothesis.apply(world, values);
  return world;
}

double discrepancyOf(const Replay& replay, const World& world, const Evidence& evidence) {
  std::vector<Comparison> comparisons = comparisonsOf(replay, world, evidence);
  return total(replay, world, comparisons, evidence.part);
}

double discrepancyTo(const Replay& replay, const World& world, const Evidence& evidence,
                     std::span<const std::vector<CellStatistics>> measured) {
  std::vector<Comparison> comparisons = comparisonsOf(replay, world, evidence);
  for (std::size_t i = 0; i < comparisons.size(); ++i) comparisons[i].measured = measured[i];
  return total(replay, world, comparisons, evidence.part);
}

double discrepancyIn(const Replay& replay, const World& truth, const World& world, const Evidence& evidence,
                     std::uint64_t seed) {
  std::vector<Comparison> measured;
  for (const std::size_t s : evidence.samples) {
    const int frames = replay.samples()[s].frames;
    measured.push_back({s, {}, frames, replay.simulate(truth, s, frames, seed), frames});
  }
  scatter(replay, truth, measured, seed);
  std::vector<Comparison> comparisons = comparisonsOf(replay, world, evidence);
  for (std::size_t i = 0; i < comparisons.size(); ++i) comparisons[i].measured = measured[i].simulated;
  return total(replay, world, comparisons, evidence.part);
}

}  // namespace gap
