#include "metrics/area/modified_area_metric.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace {

using metrics::ModifiedArea;
using metrics::modifiedAreaMetric;
using metrics::safetyFactor;

// 1.25 + 1.2 * 2.75 / n^(1/3)
TEST(SafetyFactor, FallsWithTheNumberOfExperiments) {
  EXPECT_DOUBLE_EQ(safetyFactor(1.0), 4.55);
  EXPECT_NEAR(safetyFactor(10.0), 2.7817243, 1e-7);
  EXPECT_NEAR(safetyFactor(50.0), 2.1457578, 1e-7);
  EXPECT_NEAR(safetyFactor(100.0), 1.9609634, 1e-7);
  EXPECT_NEAR(safetyFactor(1e30), 1.25, 1e-9);
}

TEST(SafetyFactor, RefusesNoExperiment) {
  for (const double n : {0.0, -1.0, std::nan("")}) {
    EXPECT_THAT([n] { (void)safetyFactor(n); },
                testing::ThrowsMessage<core::InputError>(testing::HasSubstr("needs at least one")));
  }
}

// At n = 1 the factor is 4.55: centre (0.1 - 0.5)/2, half width 4.55 * (0.1 + 0.5)/2.
TEST(ModifiedAreaMetric, IsCentredOnTheCorrectionThatAHighSimulationNeeds) {
  const ModifiedArea interval = modifiedAreaMetric({.d_plus = 0.1, .d_minus = 0.5}, 1.0);
  EXPECT_DOUBLE_EQ(interval.lower, -0.2 - 4.55 * 0.3);
  EXPECT_DOUBLE_EQ(interval.upper, -0.2 + 4.55 * 0.3);
}

// With a factor of 1 it would be [-d_minus, d_plus]; every factor in use is larger.
TEST(ModifiedAreaMetric, ContainsTheUnsafeIntervalAndZero) {
  for (const double n : {1.0, 3.0, 50.0, 1e9}) {
    const ModifiedArea interval = modifiedAreaMetric({.d_plus = 0.3, .d_minus = 0.2}, n);
    EXPECT_LT(interval.lower, -0.2);
    EXPECT_GT(interval.upper, 0.3);
  }
}

// With a factor of 1 it is [-d_minus, d_plus]: what is left when each half width is divided by the factor.
TEST(ModifiedAreaMetric, IsThePortionsTimesTheFactorAboutItsCentre) {
  for (const double n : {1.0, 10.0, 100.0}) {
    const ModifiedArea interval = modifiedAreaMetric({.d_plus = 0.3, .d_minus = 0.2}, n);
    const double centre = 0.5 * (interval.lower + interval.upper);
    const double unsafe = 0.5 * (interval.upper - interval.lower) / safetyFactor(n);
    EXPECT_NEAR(centre - unsafe, -0.2, 1e-15);
    EXPECT_NEAR(centre + unsafe, 0.3, 1e-15);
  }
}

}  // namespace
