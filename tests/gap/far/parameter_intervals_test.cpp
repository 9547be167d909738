#include "gap/far/parameter_intervals.h"

#include <gtest/gtest.h>

#include "gap/causes/split.h"
#include "tests/gap/hypothesis_named.h"
#include "tests/gap/small_world.h"

namespace {

using test_support::SmallWorld;

/// Of an effect fitted from these values, in a world that has fog of 400 m and loses nothing. The effect's first
/// number.
gap::Interval intervalOf(const std::string& effect, std::vector<double> values) {
  const SmallWorld world;
  const auto measured =
      world.measuredBy(SmallWorld::modelWith({{"atmospheric-attenuation", {{"visibility_m", 400}}}}), 0.4);
  const gap::Replay replay(measured, SmallWorld::modelWith({}));
  const auto hypothesis = test_support::hypothesisNamed(gap::hypothesesFor(replay, {effect}), effect);
  const gap::Evidence all = gap::splitOf(replay, 1).refined;
  const core::SilentProgress progress;
  values = gap::fitFrom(replay, hypothesis, all, values, progress);
  return gap::parameterIntervals(replay, hypothesis, values, all, progress).at(0);
}

TEST(ParameterIntervals, HoldTheTrueValueAndLittleElse) {
  const gap::Interval interval = intervalOf("atmospheric-attenuation", {500.0});
  EXPECT_LT(interval.low, 400.0);
  EXPECT_GT(interval.high, 400.0);
  EXPECT_LT(interval.high - interval.low, 100.0);
}

// Nobody loses less than no detection.
TEST(ParameterIntervals, EndWhereWhatIsPlausibleEnds) {
  const gap::Interval interval = intervalOf("detection-loss", {0.0});
  EXPECT_EQ(interval.low, 0.0);
  EXPECT_GT(interval.high, 0.0);
  EXPECT_LT(interval.high, 0.05);
}

TEST(ParameterIntervals, AreNoneOfOneSetUp) {
  const SmallWorld world;
  const auto model = SmallWorld::modelWith({});
  const auto measured = world.measuredBy(model, 0.4);
  const gap::Replay replay(measured, model);
  const auto offset = test_support::hypothesisNamed(gap::hypothesesFor(replay, {"range-offset"}), "range-offset");
  gap::Evidence one = gap::splitOf(replay, 1).refined;
  one.samples.resize(1);
  EXPECT_TRUE(gap::parameterIntervals(replay, offset, {0.01}, one, core::SilentProgress()).empty());
}

}  // namespace
