#include "gap/which/pair_guesses.h"

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>

#include "tests/gap/small_world.h"

namespace {

using test_support::SmallWorld;

// Fog of this density makes an echo of its own in front of every wall, unless the receiver looks past its near field:
// alone it is far from the measurement.
TEST(PairGuesses, HoldACauseThatTheOtherOneHides) {
  const std::map<std::string, double> narrow = {{"/sensor/receiver/field_of_view_rad/horizontal", 0.012},
                                                {"/sensor/receiver/field_of_view_rad/vertical", 0.012}};
  const SmallWorld world;
  const auto truth = SmallWorld::modelWith(
      {{"aperture-offset", {{"offset_m", 0.045}}}, {"atmospheric-backscatter", {{"visibility_m", 300}}}}, narrow);
  const model::Experiment experiment = world.measuredBy(truth, 0.4);
  const gap::Replay replay(experiment, SmallWorld::modelWith({}, narrow));
  const gap::Split split = gap::splitOf(replay, 1);
  const gap::Judge judge{replay, split, gap::yardstickOf(replay, split.held_out)};
  // As they would be ranked: the fog, alone, last of all.
  std::vector<gap::Candidate> singles;
  for (const gap::Hypothesis& hypothesis : gap::hypothesesFor(replay, {})) {
    std::vector<double> values;
    for (const gap::FreeParameter& parameter : hypothesis.parameters) values.push_back(parameter.start);
    singles.push_back({.hypothesis = hypothesis, .values = values});
  }
  const auto is = [](const char* name) {
    return [name](const gap::Candidate& c) { return c.hypothesis.name == name; };
  };
  std::stable_partition(singles.begin(), singles.end(), is("aperture-offset"));
  std::stable_partition(singles.begin(), singles.end(), std::not_fn(is("atmospheric-backscatter")));
  const core::SilentProgress progress;
  const auto guesses = gap::PairGuesses(judge, singles, progress).partnersOf(0, {0.045});
  ASSERT_FALSE(guesses.empty());
  EXPECT_EQ(singles[guesses.front().second].hypothesis.name, "atmospheric-backscatter");
  EXPECT_NEAR(guesses.front().values.back(), 300.0, 60.0);
}

}  // namespace
