#include "gap/causes/counters.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "gap/causes/evidence.h"
#include "tests/gap/hypothesis_named.h"
#include "tests/gap/small_world.h"

namespace {

using test_support::SmallWorld;

constexpr double kStep_m = 0.0437;      // of the counter
constexpr double kResolution_m = 0.01;  // of the profile under test

/// Ranges of the first sample in the world with a counter of these steps.
std::vector<double> rangesWithTheCounter(const model::Experiment& measured) {
  const gap::Replay replay(measured, SmallWorld::modelWith({}));
  const auto counter = test_support::hypothesisNamed(gap::hypothesesFor(replay, {"quantisation"}), "quantisation");
  return replay.detections(gap::worldOf(replay, counter, {kStep_m}), 0, 1).range_m;
}

/// Of the value that is farthest from a multiple of a step.
double farthestFrom(double step, const std::vector<double>& values) {
  double farthest = 0.0;
  for (const double value : values) farthest = std::max(farthest, std::abs(value - step * std::round(value / step)));
  return farthest;
}

TEST(Counters, WhatWasRoundedAfterItWasCountedIsRoundedInTheirWorldToo) {
  const SmallWorld world;
  const auto measured = world.measuredBy(SmallWorld::modelWith({{"quantisation", {{"range_step_m", kStep_m}}}}), 0.4);
  const std::vector<double> ranges = rangesWithTheCounter(measured);
  EXPECT_LT(farthestFrom(kResolution_m, ranges), 1e-9);
  EXPECT_GT(farthestFrom(kStep_m, ranges), 0.1 * kResolution_m);
}

// A sensor whose output holds more digits than its profile says.
TEST(Counters, WhatWasCountedAloneIsNotRoundedInTheirWorld) {
  const SmallWorld world;
  const auto measured = world.measuredBy(SmallWorld::modelWith({{"quantisation", {{"range_step_m", kStep_m}}}},
                                                               {{"/sensor/detection/range_resolution_m", 0.0}}),
                                         0.4);
  const std::vector<double> ranges = rangesWithTheCounter(measured);
  EXPECT_GT(farthestFrom(kResolution_m, ranges), 0.1 * kResolution_m);
  EXPECT_LT(farthestFrom(kStep_m, ranges), 1e-9);
}

}  // namespace
