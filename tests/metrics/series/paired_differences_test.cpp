#include "metrics/series/paired_differences.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "tests/metrics/series/random_series.h"
#include "tests/support/thrown_message.h"

namespace {

using metrics::chebyshevDistance;
using metrics::euclideanDistance;
using metrics::manhattanDistance;
using metrics::meanAbsoluteError;
using metrics::meanSignedError;
using metrics::meanSquareError;
using metrics::residualSumOfSquares;
using metrics::rootMeanSquareError;
using metrics::SeriesPair;
using metrics_test::RandomSeries;
using metrics_test::TwoSeries;
using test_support::thrownMessage;

using PairMetric = double (*)(const SeriesPair&);
constexpr std::array<PairMetric, 8> kAll = {manhattanDistance, euclideanDistance,   chebyshevDistance,
                                            meanSquareError,   rootMeanSquareError, residualSumOfSquares,
                                            meanAbsoluteError, meanSignedError};

// Differences 3, -4, 0.
TEST(PairedDifferences, OfThreeAndMinusFourFollowTheirFormulas) {
  const TwoSeries both = {.simulated = {4.0, -2.0, 7.0}, .measured = {1.0, 2.0, 7.0}};
  EXPECT_EQ(manhattanDistance(both.pair()), 7.0);
  EXPECT_EQ(euclideanDistance(both.pair()), 5.0);
  EXPECT_EQ(chebyshevDistance(both.pair()), 4.0);
  EXPECT_EQ(residualSumOfSquares(both.pair()), 25.0);
  EXPECT_DOUBLE_EQ(meanSquareError(both.pair()), 25.0 / 3.0);
  EXPECT_DOUBLE_EQ(rootMeanSquareError(both.pair()), 5.0 / std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(meanAbsoluteError(both.pair()), 7.0 / 3.0);
  EXPECT_DOUBLE_EQ(meanSignedError(both.pair()), -1.0 / 3.0);
}

TEST(PairedDifferences, OfEqualSeriesAreZero) {
  const TwoSeries both = {.simulated = {0.1, 0.2}, .measured = {0.1, 0.2}};
  for (const PairMetric metric : kAll) EXPECT_EQ(metric(both.pair()), 0.0);
}

TEST(PairedDifferences, DoNotDependOnWhichSideIsSimulatedExceptInSign) {
  RandomSeries cases(101);
  for (int k = 0; k < 100; ++k) {
    const TwoSeries both = cases.two(cases.length(1, 40));
    for (const PairMetric metric : kAll) EXPECT_EQ(std::abs(metric(both.pair())), std::abs(metric(both.exchanged())));
    EXPECT_EQ(meanSignedError(both.pair()), -meanSignedError(both.exchanged()));
  }
}

TEST(PairedDifferences, OfAConstantOffsetAreTheOffset) {
  RandomSeries cases(102);
  for (int k = 0; k < 100; ++k) {
    TwoSeries both = cases.two(cases.length(1, 40));
    const double offset = cases.uniform(-3.0, 3.0);
    std::transform(both.measured.begin(), both.measured.end(), both.simulated.begin(),
                   [offset](double x) { return x + offset; });
    EXPECT_NEAR(meanSignedError(both.pair()), offset, 1e-13);
    for (const PairMetric metric : {meanAbsoluteError, rootMeanSquareError, chebyshevDistance}) {
      EXPECT_NEAR(metric(both.pair()), std::abs(offset), 1e-13);
    }
  }
}

TEST(PairedDifferences, SumsGrowWithTheNumberOfPairsAndMeansDoNot) {
  const TwoSeries once = {.simulated = {1.0, 5.0}, .measured = {2.0, 2.0}};
  const TwoSeries twice = {.simulated = {1.0, 5.0, 1.0, 5.0}, .measured = {2.0, 2.0, 2.0, 2.0}};
  for (const PairMetric sum : {manhattanDistance, residualSumOfSquares}) {
    EXPECT_EQ(sum(twice.pair()), 2.0 * sum(once.pair()));
  }
  for (const PairMetric mean : {meanAbsoluteError, meanSquareError, rootMeanSquareError, meanSignedError}) {
    EXPECT_EQ(mean(twice.pair()), mean(once.pair()));
  }
}

// Norms of one difference vector: |.|_inf <= |.|_2 <= |.|_1 <= sqrt(n) |.|_2 <= n |.|_inf.
TEST(PairedDifferences, AreOrderedAsTheNormsThatTheyAre) {
  RandomSeries cases(103);
  for (int k = 0; k < 200; ++k) {
    const std::size_t n = cases.length(1, 40);
    const TwoSeries both = cases.two(n);
    const double root = std::sqrt(static_cast<double>(n));
    const double rounding = 1.0 + 1e-14;
    EXPECT_LE(chebyshevDistance(both.pair()), euclideanDistance(both.pair()) * rounding);
    EXPECT_LE(euclideanDistance(both.pair()), manhattanDistance(both.pair()) * rounding);
    EXPECT_LE(manhattanDistance(both.pair()), root * euclideanDistance(both.pair()) * rounding);
    EXPECT_LE(root * euclideanDistance(both.pair()), root * root * chebyshevDistance(both.pair()) * rounding);
    EXPECT_LE(std::abs(meanSignedError(both.pair())), meanAbsoluteError(both.pair()) * rounding);
    EXPECT_LE(meanAbsoluteError(both.pair()), rootMeanSquareError(both.pair()) * rounding);
  }
}

TEST(PairedDifferences, DistancesObeyTheTriangleInequality) {
  RandomSeries cases(104);
  for (int k = 0; k < 200; ++k) {
    const TwoSeries ends = cases.two(12);
    const std::vector<double> between = cases.series(12);
    for (const PairMetric distance :
         {manhattanDistance, euclideanDistance, chebyshevDistance, meanAbsoluteError, rootMeanSquareError}) {
      EXPECT_LE(distance(ends.pair()), distance({.simulated = ends.simulated, .measured = between}) +
                                           distance({.simulated = between, .measured = ends.measured}) + 1e-12);
    }
  }
}

TEST(PairedDifferences, RefuseWhatDoesNotPairAndSayWhere) {
  const std::vector<double> three = {1.0, 2.0, 3.0};
  const std::vector<double> two = {1.0, 2.0};
  const std::vector<double> hole = {1.0, std::numeric_limits<double>::quiet_NaN(), 3.0};
  const std::vector<double> endless = {1.0, 2.0, -std::numeric_limits<double>::infinity()};
  for (const PairMetric metric : kAll) {
    const auto message = [metric](const std::vector<double>& simulated, const std::vector<double>& measured) {
      return thrownMessage([&] { (void)metric({.simulated = simulated, .measured = measured}); });
    };
    EXPECT_EQ(message(three, two).rfind("simulated and measured series: have 3 and 2 values", 0), 0u);
    EXPECT_EQ(message(three, hole).rfind("measured series, value 2: is nan", 0), 0u);
    EXPECT_EQ(message(endless, three).rfind("simulated series, value 3: is -inf", 0), 0u);
    EXPECT_EQ(message({}, {}).rfind("simulated series: has no values", 0), 0u);
  }
}

}  // namespace
