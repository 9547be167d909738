#include "gap/which/pair_guesses.h"

#include <algorithm>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/gap/small_world.h"
#include "tests/gap/usual_causes.h"

namespace {

using test_support::SmallWorld;

/// A measurement, the causes that may explain it as they are usual, and what pairs are guessed of them.
class GuessedPairs {
 public:
  /// The world lives longer. Of the causes, which are best first, the one of the first name leads, and those of the
  /// other come last.
  GuessedPairs(const SmallWorld& world, const SmallWorld::Effects& truth, const std::string& first,
               const std::string& last, const std::map<std::string, double>& sensor = {},
               double true_reflectivity = 0.4)
      : measured_(world.measuredBy(SmallWorld::modelWith(truth, sensor), true_reflectivity)),
        replay_(measured_, SmallWorld::modelWith({}, sensor)) {
    const auto is = [](const std::string& name) {
      return [name](const gap::Candidate& c) { return c.hypothesis.name == name; };
    };
    std::stable_partition(singles_.begin(), singles_.end(), is(first));
    std::stable_partition(singles_.begin(), singles_.end(), std::not_fn(is(last)));
  }

  [[nodiscard]] gap::PairGuesses guesses() const { return {judge_, singles_, progress_}; }
  [[nodiscard]] const std::string& nameOf(std::size_t single) const { return singles_[single].hypothesis.name; }

 private:
  model::Experiment measured_;
  gap::Replay replay_;
  gap::Split split_ = gap::splitOf(replay_, 1);
  gap::Judge judge_{replay_, split_, gap::yardstickOf(replay_, split_.held_out)};
  std::vector<gap::Candidate> singles_ = test_support::usualCauses(replay_);
  core::SilentProgress progress_;
};

// Fog of this density makes an echo of its own in front of every wall, unless the receiver looks past its near field:
// alone it is far from the measurement.
TEST(PairGuesses, HoldACauseThatTheOtherOneHides) {
  const SmallWorld world;
  const GuessedPairs pairs(
      world, {{"aperture-offset", {{"offset_m", 0.045}}}, {"atmospheric-backscatter", {{"visibility_m", 300}}}},
      "aperture-offset", "atmospheric-backscatter", SmallWorld::narrowView());
  const auto guesses = pairs.guesses().partnersOf(0, {0.045});
  ASSERT_FALSE(guesses.empty());
  EXPECT_EQ(pairs.nameOf(guesses.front().second), "atmospheric-backscatter");
  EXPECT_NEAR(guesses.front().values.back(), 300.0, 60.0);
}

// Echoes 9 m apart are one: where the wall is seen through the pane, the first echo of two walls is wide, and no second
// one comes. Alone, neither what lets light through nor what merges echoes makes a wide one.
TEST(PairGuesses, HoldTwoEffectsOfWhichOneDoesNothingWithoutTheOther) {
  SmallWorld world;
  world.behindAPane(4.0);
  const GuessedPairs pairs(world,
                           {{"transmission", {{"transmission", 0.6}}}, {"echo-merging", {{"separation_m", 9.5}}}},
                           "range-offset", "transmission");
  const auto guesses = pairs.guesses().nearestOfEveryTwo();
  ASSERT_FALSE(guesses.empty());
  EXPECT_THAT((std::vector{pairs.nameOf(guesses.front().first), pairs.nameOf(guesses.front().second)}),
              testing::UnorderedElementsAre("echo-merging", "transmission"));
}

// The model was calibrated in haze, so that its walls are darker than they are. The noise is that of a weak sensor:
// cells with an echo or two are off by ten errors, and squares of these hide what all others say.
TEST(PairGuesses, HoldACauseThatARecalibrationHides) {
  const SmallWorld world;
  const GuessedPairs pairs(world, {{"atmospheric-attenuation", {{"visibility_m", 4666.0}}}}, "range-offset",
                           "atmospheric-attenuation",
                           {{"/sensor/receiver/threshold_w", 1.2e-7}, {"/sensor/receiver/noise_w", 4e-8}}, 0.405);
  std::vector<std::string> beside_haze;
  for (const gap::Guess& guess : pairs.guesses().besideRecalibration())
    if (pairs.nameOf(guess.first) == "atmospheric-attenuation") beside_haze.push_back(pairs.nameOf(guess.second));
  EXPECT_THAT(beside_haze,
              testing::Contains(testing::AnyOf("/sensor/emitter/peak_power_w", "/materials/plaster/reflectivity")));
}

}  // namespace
