#include "gap/which/pair_guesses.h"

#include <algorithm>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/gap/small_world.h"

namespace {

using test_support::SmallWorld;

/// All causes as they are usual, best first: the one of this name, and those of the other one last.
std::vector<gap::Candidate> inOrder(const gap::Replay& replay, const std::string& first, const std::string& last) {
  std::vector<gap::Candidate> singles;
  for (const gap::Hypothesis& hypothesis : gap::hypothesesFor(replay, {})) {
    std::vector<double> values;
    for (const gap::FreeParameter& parameter : hypothesis.parameters) values.push_back(parameter.start);
    singles.push_back({.hypothesis = hypothesis, .values = values});
  }
  const auto is = [](const std::string& name) {
    return [name](const gap::Candidate& c) { return c.hypothesis.name == name; };
  };
  std::stable_partition(singles.begin(), singles.end(), is(first));
  std::stable_partition(singles.begin(), singles.end(), std::not_fn(is(last)));
  return singles;
}

const std::map<std::string, double> kNarrow = {{"/sensor/receiver/field_of_view_rad/horizontal", 0.012},
                                               {"/sensor/receiver/field_of_view_rad/vertical", 0.012}};

// Fog of this density makes an echo of its own in front of every wall, unless the receiver looks past its near field:
// alone it is far from the measurement.
TEST(PairGuesses, HoldACauseThatTheOtherOneHides) {
  const SmallWorld world;
  const auto truth = SmallWorld::modelWith(
      {{"aperture-offset", {{"offset_m", 0.045}}}, {"atmospheric-backscatter", {{"visibility_m", 300}}}}, kNarrow);
  const model::Experiment experiment = world.measuredBy(truth, 0.4);
  const gap::Replay replay(experiment, SmallWorld::modelWith({}, kNarrow));
  const gap::Split split = gap::splitOf(replay, 1);
  const gap::Judge judge{replay, split, gap::yardstickOf(replay, split.held_out)};
  const auto singles = inOrder(replay, "aperture-offset", "atmospheric-backscatter");
  const core::SilentProgress progress;
  const auto guesses =
      gap::PairGuesses(judge, singles, progress).partnersOf(0, {0.045}, gap::PairGuesses::Look::kBriefly);
  ASSERT_FALSE(guesses.empty());
  EXPECT_EQ(singles[guesses.front().second].hypothesis.name, "atmospheric-backscatter");
  EXPECT_NEAR(guesses.front().values.back(), 300.0, 60.0);
}

// 8 m away an offset of 56.5 mm takes nearly all light; two millimetres more take all, two less half as much.
TEST(PairGuesses, HoldACauseOfANumberBetweenThePlacesThatAreLookedAt) {
  const SmallWorld world;
  const auto truth = SmallWorld::modelWith(
      {{"aperture-offset", {{"offset_m", 0.0565}}}, {"range-offset", {{"offset_m", 0.05}}}}, kNarrow);
  const model::Experiment experiment = world.measuredBy(truth, 0.4);
  const gap::Replay replay(experiment, SmallWorld::modelWith({}, kNarrow));
  const gap::Split split = gap::splitOf(replay, 1);
  const gap::Judge judge{replay, split, gap::yardstickOf(replay, split.held_out)};
  const auto singles = inOrder(replay, "range-offset", "aperture-offset");
  const core::SilentProgress progress;
  const auto partners =
      gap::PairGuesses(judge, singles, progress).partnersOf(0, {0.05}, gap::PairGuesses::Look::kClosely);
  const auto aperture = std::find_if(partners.begin(), partners.end(), [&](const gap::Guess& guess) {
    return singles[guess.second].hypothesis.name == "aperture-offset";
  });
  ASSERT_NE(aperture, partners.end());
  EXPECT_NEAR(aperture->values.back(), 0.0565, 0.0005);
}

// Echoes 9 m apart are one: where the wall is seen through the pane, the first echo of two walls is wide, and no second
// one comes. Alone, neither what lets light through nor what merges echoes makes a wide one.
TEST(PairGuesses, HoldTwoEffectsOfWhichOneDoesNothingWithoutTheOther) {
  SmallWorld world;
  world.behindAPane(4.0);
  const auto truth =
      SmallWorld::modelWith({{"transmission", {{"transmission", 0.6}}}, {"echo-merging", {{"separation_m", 9.5}}}});
  const model::Experiment experiment = world.measuredBy(truth, 0.4);
  const gap::Replay replay(experiment, SmallWorld::modelWith({}));
  const gap::Split split = gap::splitOf(replay, 1);
  const gap::Judge judge{replay, split, gap::yardstickOf(replay, split.held_out)};
  const auto singles = inOrder(replay, "range-offset", "transmission");
  const core::SilentProgress progress;
  const auto guesses = gap::PairGuesses(judge, singles, progress).nearestOfEveryTwo();
  ASSERT_FALSE(guesses.empty());
  const auto& [first, second, values, distance] = guesses.front();
  EXPECT_THAT((std::vector{singles[first].hypothesis.name, singles[second].hypothesis.name}),
              testing::UnorderedElementsAre("echo-merging", "transmission"));
}

}  // namespace
