#include "gap/which/exchanges.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "gap/far/how_far.h"
#include "tests/gap/small_world.h"

namespace {

using test_support::SmallWorld;

gap::Candidate candidateOf(const gap::Replay& replay, const std::string& name, const std::vector<double>& values,
                           const std::string& form = "") {
  const auto all = gap::hypothesesFor(replay, {name});
  return {*std::find_if(all.begin(), all.end(), [&](const auto& h) { return h.name == name && h.variant == form; }),
          values};
}

// Speckle of 100 looks scatters power by 1/√100 (Goodman 2007, eq. 3-26), as a jitter of the pulse's power by 0.1 does.
// Alone, that jitter had been fitted to half of it.
TEST(Exchanges, ACauseThatDoesTheSameIsFittedBesideTheOtherMember) {
  const SmallWorld world;
  const model::Experiment experiment = world.measuredBy(
      SmallWorld::modelWith({{"speckle", {{"looks", 100}}}, {"detection-loss", {{"probability", 0.1}}}}), 0.4);
  const gap::Replay replay(experiment, SmallWorld::modelWith({}));
  const gap::Split split = gap::splitOf(replay, 1);
  const gap::Judge judge{replay, split, gap::yardstickOf(replay, split.held_out)};
  const gap::HeldOutGaps gaps(replay, split.held_out.samples, 1);
  const gap::Candidate speckle = candidateOf(replay, "speckle", {100.0});
  const gap::Candidate loss = candidateOf(replay, "detection-loss", {0.1});
  const std::vector<gap::Candidate> singles{speckle, loss, candidateOf(replay, "pulse-jitter", {0.0, 0.05}),
                                            candidateOf(replay, "clock-drift", {1000.0})};
  std::vector<gap::Candidate> pairs{{.hypothesis = gap::together(speckle.hypothesis, loss.hypothesis),
                                     .values = gap::joined(speckle.values, loss.values)}};
  judge.hear(pairs.front());
  gap::exchangeMembers(judge, judge, gaps, singles, pairs, core::SilentProgress());
  const auto exchanged = std::find_if(pairs.begin(), pairs.end(), [](const gap::Candidate& pair) {
    return pair.hypothesis.name == "detection-loss + pulse-jitter";
  });
  ASSERT_NE(exchanged, pairs.end());
  EXPECT_NEAR(exchanged->values[0], 0.1, 0.01);  // loss
  EXPECT_NEAR(exchanged->values[2], 0.1, 0.01);  // power of the pulse
  EXPECT_NEAR(exchanged->explained, 1.0, 0.1);
}

// A threshold that is 12 times the noise is another constant threshold; one that falls with range (by nothing) comes as
// near and has a number more, so that nobody would put it in the place of a parameter.
TEST(Exchanges, TheUsualFormOfACauseIsTriedWhereAnotherFormComesNearest) {
  const SmallWorld world;
  const model::Experiment experiment = world.measuredBy(
      SmallWorld::modelWith({{"dynamic-threshold", {{"factor", 12}}}, {"detection-loss", {{"probability", 0.1}}}}),
      0.4);
  const gap::Replay replay(experiment, SmallWorld::modelWith({}));
  const gap::Split split = gap::splitOf(replay, 1);
  const gap::Judge judge{replay, split, gap::yardstickOf(replay, split.held_out)};
  const gap::HeldOutGaps gaps(replay, split.held_out.samples, 1);
  const gap::Candidate loss = candidateOf(replay, "detection-loss", {0.1});
  const gap::Candidate offset = candidateOf(replay, "range-offset", {0.01});
  const std::vector<gap::Candidate> singles{
      offset, loss, candidateOf(replay, "dynamic-threshold", {14.0}),
      candidateOf(replay, "dynamic-threshold", {12.0, 0.0}, "falling with range")};
  std::vector<gap::Candidate> pairs{{.hypothesis = gap::together(loss.hypothesis, offset.hypothesis),
                                     .values = gap::joined(loss.values, offset.values)}};
  judge.hear(pairs.front());
  gap::exchangeMembers(judge, judge, gaps, singles, pairs, core::SilentProgress());
  const auto usual = std::find_if(pairs.begin(), pairs.end(), [](const gap::Candidate& pair) {
    return pair.hypothesis.name == "detection-loss + dynamic-threshold" && pair.hypothesis.variant.empty();
  });
  ASSERT_NE(usual, pairs.end());
  EXPECT_NEAR(usual->values[1], 12.0, 0.2);
}

}  // namespace
