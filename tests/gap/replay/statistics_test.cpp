#include "gap/replay/statistics.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace {

// Of two numbers Student's t has the distribution of Cauchy: P(|t| > 2) = 1 - 2/π atan 2.
TEST(Statistics, AMeanByChanceIsThatOfStudent) {
  EXPECT_NEAR(gap::meanByChance({1.0, 3.0}), 1.0 - 2.0 / std::numbers::pi * std::atan(2.0), 1e-12);
  EXPECT_NEAR(gap::meanByChance({-1.0, -3.0}), 1.0 - 2.0 / std::numbers::pi * std::atan(2.0), 1e-12);
  EXPECT_NEAR(gap::meanByChance({-1.0, 1.0}), 1.0, 1e-12);
}

TEST(Statistics, OfEqualNumbersNoMeanIsByChance) { EXPECT_LT(gap::meanByChance({0.1, 0.1, 0.1}), 1e-6); }

}  // namespace
