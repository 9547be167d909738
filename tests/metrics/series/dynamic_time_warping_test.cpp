#include "metrics/series/dynamic_time_warping.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "metrics/series/paired_differences.h"
#include "tests/metrics/series/random_series.h"
#include "tests/support/thrown_message.h"

namespace {

using metrics::dynamicTimeWarping;
using metrics::manhattanDistance;
using metrics::SeriesPair;
using metrics_test::RandomSeries;
using metrics_test::TwoSeries;
using test_support::thrownMessage;

/// The definition without a table: tries every path from (i, j) to the end.
double ofAllPaths(const SeriesPair& s, std::size_t window, std::size_t i = 0, std::size_t j = 0) {
  const std::size_t n = s.simulated.size();
  const std::size_t m = s.measured.size();
  if (i >= n || j >= m || (i > j ? i - j : j - i) > window) return std::numeric_limits<double>::infinity();
  const double here = std::abs(s.simulated[i] - s.measured[j]);
  if (i + 1 == n && j + 1 == m) return here;
  return here + std::min({ofAllPaths(s, window, i + 1, j), ofAllPaths(s, window, i, j + 1),
                          ofAllPaths(s, window, i + 1, j + 1)});
}

TEST(DynamicTimeWarping, IsTheLeastSumOfAllPaths) {
  RandomSeries cases(131);
  for (int k = 0; k < 300; ++k) {
    const TwoSeries both = cases.two(cases.length(1, 7), cases.length(1, 7));
    EXPECT_NEAR(dynamicTimeWarping(both.pair()), ofAllPaths(both.pair(), 7), 1e-12);
  }
}

TEST(DynamicTimeWarping, WithinABandIsTheLeastSumOfThePathsInIt) {
  RandomSeries cases(132);
  for (int k = 0; k < 300; ++k) {
    const std::size_t n = cases.length(1, 7);
    const std::size_t m = cases.length(1, 7);
    const TwoSeries both = cases.two(n, m);
    for (std::size_t window = std::max(n, m) - std::min(n, m); window <= 7; ++window) {
      EXPECT_NEAR(dynamicTimeWarping(both.pair(), window), ofAllPaths(both.pair(), window), 1e-12);
    }
  }
}

// A step of height 5 that comes two values late: every value by which the band is too narrow costs 5.
TEST(DynamicTimeWarping, ForgivesADelayWithinTheWindow) {
  const TwoSeries both = {.simulated = {0.0, 0.0, 0.0, 5.0, 5.0, 5.0}, .measured = {0.0, 5.0, 5.0, 5.0, 5.0, 5.0}};
  EXPECT_EQ(dynamicTimeWarping(both.pair()), 0.0);
  EXPECT_EQ(dynamicTimeWarping(both.pair(), 2), 0.0);
  EXPECT_EQ(dynamicTimeWarping(both.pair(), 1), 5.0);
  EXPECT_EQ(dynamicTimeWarping(both.pair(), 0), 10.0);
}

// D by hand: 0 1 3 / 1 0 1 / 3 1 0 / 5 2 0.
TEST(DynamicTimeWarping, OfDifferentLengthsReachesBothEnds) {
  const TwoSeries both = {.simulated = {1.0, 2.0, 3.0, 3.0}, .measured = {1.0, 2.0, 3.0}};
  EXPECT_EQ(dynamicTimeWarping(both.pair()), 0.0);
  const TwoSeries one_value = {.simulated = {1.0, 2.0, 4.0}, .measured = {2.0}};
  EXPECT_EQ(dynamicTimeWarping(one_value.pair()), 3.0);
}

TEST(DynamicTimeWarping, HoldingAValueCostsNothing) {
  RandomSeries cases(133);
  for (int k = 0; k < 100; ++k) {
    const std::vector<double> measured = cases.series(cases.length(1, 20));
    std::vector<double> simulated;
    for (const double x : measured) simulated.insert(simulated.end(), cases.length(1, 4), x);
    EXPECT_EQ(dynamicTimeWarping({.simulated = simulated, .measured = measured}), 0.0);
  }
}

TEST(DynamicTimeWarping, IsSymmetricAndBlindToACommonOffset) {
  RandomSeries cases(134);
  for (int k = 0; k < 100; ++k) {
    TwoSeries both = cases.two(cases.length(1, 30), cases.length(1, 30));
    const double distance = dynamicTimeWarping(both.pair());
    EXPECT_EQ(distance, dynamicTimeWarping(both.exchanged()));
    for (double& x : both.simulated) x += 8.0;
    for (double& x : both.measured) x += 8.0;
    EXPECT_NEAR(distance, dynamicTimeWarping(both.pair()), 1e-11);
  }
}

TEST(DynamicTimeWarping, FallsFromManhattanToFreeAsTheWindowOpens) {
  RandomSeries cases(135);
  for (int k = 0; k < 50; ++k) {
    const std::size_t n = cases.length(1, 40);
    const TwoSeries both = cases.two(n);
    double before = manhattanDistance(both.pair());
    EXPECT_NEAR(dynamicTimeWarping(both.pair(), 0), before, 1e-12);
    for (std::size_t window = 0; window <= n; ++window) {
      const double now = dynamicTimeWarping(both.pair(), window);
      EXPECT_LE(now, before + 1e-12);
      before = now;
    }
    EXPECT_EQ(before, dynamicTimeWarping(both.pair()));
    EXPECT_EQ(before, dynamicTimeWarping(both.pair(), std::numeric_limits<std::size_t>::max()));
  }
}

// The way by b is shorter than the direct one: violates the triangle inequality.
TEST(DynamicTimeWarping, IsNoMetric) {
  const std::vector<double> a = {0.0};
  const std::vector<double> b = {1.0, 2.0};
  const std::vector<double> c = {2.0, 2.0, 2.0};
  const double direct = dynamicTimeWarping({.simulated = a, .measured = c});         // 6
  const double by_way_of_b = dynamicTimeWarping({.simulated = a, .measured = b})     // 3
                             + dynamicTimeWarping({.simulated = b, .measured = c});  // 1
  EXPECT_EQ(direct, 6.0);
  EXPECT_EQ(by_way_of_b, 4.0);
}

TEST(DynamicTimeWarping, RefusesABandThatMissesTheEnd) {
  const TwoSeries both = {.simulated = {1.0, 2.0, 3.0, 4.0}, .measured = {1.0, 2.0}};
  EXPECT_EQ(thrownMessage([&] { (void)dynamicTimeWarping(both.pair(), 2); }), "");
  const std::string message = thrownMessage([&] { (void)dynamicTimeWarping(both.pair(), 1); });
  EXPECT_NE(message.find("warping window: is 1"), std::string::npos);
  EXPECT_NE(message.find("Give at least 2"), std::string::npos);
}

TEST(DynamicTimeWarping, RefusesHolesAndEmptySeries) {
  const TwoSeries hole = {.simulated = {1.0, std::nan("")}, .measured = {1.0}};
  EXPECT_NE(thrownMessage([&] { (void)dynamicTimeWarping(hole.pair()); }).find("simulated series, value 2"),
            std::string::npos);
  EXPECT_NE(thrownMessage([&] { (void)dynamicTimeWarping({}); }).find("has no values"), std::string::npos);
}

}  // namespace
