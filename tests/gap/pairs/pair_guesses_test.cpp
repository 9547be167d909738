#include "gap/pairs/pair_guesses.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/gap/looked_at_causes.h"

namespace {

using test_support::LookedAtCauses;
using test_support::SmallWorld;

// Fog of this density makes an echo of its own in front of every wall, unless the receiver looks past its near field:
// alone it is far from the measurement.
TEST(PairGuesses, HoldACauseThatTheOtherOneHides) {
  const SmallWorld world;
  const LookedAtCauses causes(
      world, {{"aperture-offset", {{"offset_m", 0.045}}}, {"atmospheric-backscatter", {{"visibility_m", 300}}}},
      "aperture-offset", "atmospheric-backscatter", SmallWorld::narrowView());
  const gap::Looks looks = causes.looks();
  const auto guesses = gap::PairGuesses(looks).partnersOf(0, {0.045});
  ASSERT_FALSE(guesses.empty());
  EXPECT_EQ(causes.nameOf(guesses.front().second), "atmospheric-backscatter");
  EXPECT_NEAR(guesses.front().values.back(), 300.0, 60.0);
}

// Echoes 9 m apart are one: where the wall is seen through the pane, the first echo of two walls is wide, and no second
// one comes. Alone, neither what lets light through nor what merges echoes makes a wide one.
TEST(PairGuesses, HoldTwoEffectsOfWhichOneDoesNothingWithoutTheOther) {
  SmallWorld world;
  world.behindAPane(4.0);
  const LookedAtCauses causes(world,
                              {{"transmission", {{"transmission", 0.6}}}, {"echo-merging", {{"separation_m", 9.5}}}},
                              "range-offset", "transmission");
  const gap::Looks looks = causes.looks();
  const auto guesses = gap::PairGuesses(looks).nearestOfEveryTwo();
  ASSERT_FALSE(guesses.empty());
  EXPECT_THAT((std::vector{causes.nameOf(guesses.front().first), causes.nameOf(guesses.front().second)}),
              testing::UnorderedElementsAre("echo-merging", "transmission"));
}

}  // namespace
