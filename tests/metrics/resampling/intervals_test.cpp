#include "metrics/resampling/intervals.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>
#include <vector>

#include "core/error.h"
#include "tests/metrics/random_cases.h"

namespace {

using metrics::bcaInterval;
using metrics::ConfidenceInterval;
using metrics::percentileInterval;
using metrics::replicateQuantile;

std::vector<double> oneTo(int last) {
  std::vector<double> numbers(static_cast<std::size_t>(last));
  std::iota(numbers.begin(), numbers.end(), 1.0);
  return numbers;
}

// With B = 999 the level 0.025 is rank 25: why such numbers of replicates are customary.
TEST(ReplicateQuantile, IsTheOrderStatisticAtRankBPlusOneTimesP) {
  EXPECT_NEAR(replicateQuantile(oneTo(999), 0.025), 25.0, 1e-12);
  EXPECT_NEAR(replicateQuantile(oneTo(999), 0.975), 975.0, 1e-12);
  EXPECT_NEAR(replicateQuantile(oneTo(4), 0.5), 2.5, 1e-15);
}

TEST(ReplicateQuantile, NeverLeavesTheReplicates) {
  EXPECT_EQ(replicateQuantile(oneTo(10), 0.0), 1.0);
  EXPECT_EQ(replicateQuantile(oneTo(10), 1e-9), 1.0);
  EXPECT_EQ(replicateQuantile(oneTo(10), 1.0), 10.0);
}

TEST(PercentileInterval, HasTheMomentsOfTheReplicates) {
  const std::vector<double> replicates{1.0, 2.0, 3.0, 4.0, 5.0};
  const ConfidenceInterval interval = percentileInterval(2.0, replicates, 0.5);
  EXPECT_DOUBLE_EQ(interval.bias, 1.0);
  EXPECT_DOUBLE_EQ(interval.standard_error, std::sqrt(2.5));
  EXPECT_DOUBLE_EQ(interval.low, 1.5);  // rank 6 / 4
  EXPECT_DOUBLE_EQ(interval.high, 4.5);
  EXPECT_DOUBLE_EQ(interval.width(), 3.0);
}

TEST(PercentileInterval, IsUndefinedIfAReplicateIs) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(percentileInterval(2.0, std::vector{1.0, nan, 3.0}, 0.9).low));
  EXPECT_TRUE(std::isnan(percentileInterval(nan, std::vector{1.0, 3.0}, 0.9).high));
}

TEST(PercentileInterval, RefusesWhatCannotBeAnInterval) {
  EXPECT_THROW((void)percentileInterval(0.0, oneTo(10), 0.0), core::InputError);
  EXPECT_THROW((void)percentileInterval(0.0, oneTo(10), 1.0), core::InputError);
  EXPECT_THROW((void)percentileInterval(0.0, oneTo(1), 0.9), core::InputError);
}

TEST(BcaInterval, IsThePercentileIntervalWithoutBiasAndSkewness) {
  const std::vector<double> replicates = oneTo(999);
  const std::vector<double> influences{-2.0, -1.0, 1.0, 2.0};
  const ConfidenceInterval bca = bcaInterval(500.0, replicates, influences, 0.9);
  const ConfidenceInterval percentile = percentileInterval(500.0, replicates, 0.9);
  EXPECT_NEAR(bca.low, percentile.low, 1e-9);
  EXPECT_NEAR(bca.high, percentile.high, 1e-9);
}

// eqs. 14.9 and 14.10 with z0 = 0 and one influence d: a = 1/6. For 90 %, z = -+1.6448536:
// Phi(z / (1 - z / 6)) = Phi(-1.2909...) = 0.098370, Phi(2.2662...) = 0.988281.
TEST(BcaInterval, TakesTheLevelsOfThePublishedFormula) {
  const ConfidenceInterval interval = bcaInterval(50000.0, oneTo(99999), std::vector{3.0}, 0.9);
  EXPECT_NEAR(interval.low, 1e5 * 0.5 * std::erfc(1.6448536269514722 / (1.0 + 1.6448536269514722 / 6.0) / std::sqrt(2)),
              1e-3);
  EXPECT_NEAR(interval.high,
              1e5 * 0.5 * std::erfc(-1.6448536269514722 / (1.0 - 1.6448536269514722 / 6.0) / std::sqrt(2)), 1e-3);
}

TEST(BcaInterval, SurvivesReplicatesAllOnOneSide) {
  const ConfidenceInterval interval = bcaInterval(-1.0, oneTo(1000), std::vector{-1.0, 1.0}, 0.95);
  EXPECT_EQ(interval.low, 1.0);
  EXPECT_GE(interval.high, interval.low);
  EXPECT_LT(interval.high, 100.0);
}

// A monotonic map of the figure maps the interval: what percentile and BCa have and "estimate -+ 2 errors" has not.
TEST(BcaInterval, RespectsAMonotonicTransformation) {
  metrics_test::RandomCases cases(62);
  std::vector<double> replicates(999);
  std::vector<double> mapped;
  for (double& x : replicates) x = cases.uniform(0.0, 1.0);
  for (const double x : replicates) mapped.push_back(x * x * x);
  const std::vector<double> influences{0.1, -0.3, 0.5};
  const ConfidenceInterval interval = bcaInterval(0.4, replicates, influences, 0.9);
  const ConfidenceInterval of_map = bcaInterval(0.064, mapped, influences, 0.9);
  EXPECT_NEAR(of_map.low, std::pow(interval.low, 3.0), 1e-2);  // neighbouring replicates are 1e-3 apart
  EXPECT_NEAR(of_map.high, std::pow(interval.high, 3.0), 1e-2);
}

}  // namespace
