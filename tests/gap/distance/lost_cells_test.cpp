#include <gtest/gtest.h>

#include "gap/causes/split.h"
#include "gap/distance/discrepancy.h"
#include "tests/gap/small_world.h"

// Surfaces of which a world loses every echo.
namespace {

using test_support::SmallWorld;

/// Discrepancy of a model to a measurement.
double discrepancyOf(const model::LidarModel& model, const model::LidarModel& truth) {
  const SmallWorld world;
  const model::Experiment experiment = world.measuredBy(truth, 0.4);
  const gap::Replay replay(experiment, SmallWorld::modelWith({}));
  gap::World tried = replay.baseline();
  tried.model = model;
  return gap::discrepancyOf(replay, tried, gap::splitOf(replay, 1).held_out);
}

model::LidarModel losingAll() {
  return SmallWorld::modelWith({{"range-gating", {{"from_m", 100.0}, {"to_m", 150.0}}}});
}

// Ranges are off by a hundred standard errors: a lost echo may not cost less than that, or whatever takes all echoes
// would account for most of the gap.
TEST(LostCells, AreAsWrongAsTheValuesWereWithoutACause) {
  const auto off = SmallWorld::modelWith({{"range-offset", {{"offset_m", 0.4}}}});
  EXPECT_GE(discrepancyOf(losingAll(), off), discrepancyOf(SmallWorld::modelWith({}), off));
}

TEST(LostCells, AreRightWhereTheMeasurementHasNone) {
  const auto nearer = SmallWorld::modelWith({{"range-gating", {{"from_m", 100.0}, {"to_m", 140.0}}}});
  // Some detections must have been measured, or there is nothing to pair with.
  const auto alarms = SmallWorld::modelWith(
      {{"range-gating", {{"from_m", 100.0}, {"to_m", 140.0}}}, {"false-alarm", {{"rate_per_beam", 0.01}}}});
  EXPECT_LT(discrepancyOf(nearer, alarms), 0.1 * discrepancyOf(SmallWorld::modelWith({}), alarms));
}

}  // namespace
