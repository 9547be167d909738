#include "metrics/series/lagged_correlation.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "metrics/series/correlation.h"
#include "tests/metrics/series/random_series.h"
#include "tests/support/thrown_message.h"

namespace {

using metrics::autocorrelationDifference;
using metrics::CrossCorrelation;
using metrics::crossCorrelation;
using metrics::pearsonCorrelation;
using metrics_test::RandomSeries;
using metrics_test::TwoSeries;
using test_support::thrownMessage;

/// 0 but for a pulse 1, 3, 1 about `centre`.
std::vector<double> pulse(std::size_t n, std::size_t centre) {
  std::vector<double> series(n, 0.0);
  series[centre - 1] = 1.0;
  series[centre] = 3.0;
  series[centre + 1] = 1.0;
  return series;
}

std::vector<double> wave(std::size_t n, double period) {
  std::vector<double> series;
  for (std::size_t i = 0; i < n; ++i) {
    series.push_back(std::sin(2.0 * std::numbers::pi * static_cast<double>(i) / period));
  }
  return series;
}

TEST(CrossCorrelation, FindsHowMuchLaterTheSimulationComes) {
  for (const int delay : {-7, -1, 0, 2, 9}) {
    const std::vector<double> measured = pulse(60, 30);
    const std::vector<double> simulated = pulse(60, static_cast<std::size_t>(30 + delay));
    const CrossCorrelation best = crossCorrelation({.simulated = simulated, .measured = measured});
    EXPECT_EQ(best.lag, delay);
    EXPECT_GT(best.maximum, 0.99);
  }
}

TEST(CrossCorrelation, OfEqualSeriesIsOneAtLagZero) {
  RandomSeries cases(121);
  for (int k = 0; k < 50; ++k) {
    const std::vector<double> series = cases.series(cases.length(20, 60));
    const CrossCorrelation best = crossCorrelation({.simulated = series, .measured = series}, series.size() - 1);
    EXPECT_NEAR(best.maximum, 1.0, 1e-13);
    EXPECT_EQ(best.lag, 0.0);
  }
}

TEST(CrossCorrelation, WithinLagZeroIsPearsons) {
  RandomSeries cases(122);
  for (int k = 0; k < 50; ++k) {
    const TwoSeries both = cases.two(cases.length(20, 60));
    EXPECT_NEAR(crossCorrelation(both.pair(), 0).maximum, pearsonCorrelation(both.pair()), 1e-13);
  }
}

TEST(CrossCorrelation, ExchangedSidesHaveTheOppositeLag) {
  RandomSeries cases(123);
  for (int k = 0; k < 50; ++k) {
    const TwoSeries both = cases.two(cases.length(20, 60));
    const CrossCorrelation best = crossCorrelation(both.pair());
    const CrossCorrelation exchanged = crossCorrelation(both.exchanged());
    EXPECT_DOUBLE_EQ(best.maximum, exchanged.maximum);
    EXPECT_EQ(best.lag, -exchanged.lag);
  }
}

TEST(CrossCorrelation, MayOnlyGrowWithTheLagsThatAreSearched) {
  RandomSeries cases(124);
  const TwoSeries both = cases.two(50);
  double before = -1.0;
  for (std::size_t lag = 0; lag < 50; ++lag) {
    const double now = crossCorrelation(both.pair(), lag).maximum;
    EXPECT_GE(now, before);
    before = now;
  }
}

// Both series read the same backwards, so r(k) = r(-k); all numbers are whole, so exactly.
TEST(CrossCorrelation, PrefersTheLaterOfTwoEqualLags) {
  const std::vector<double> measured = {0.0, 0.0, 0.0, 0.0, 9.0, 0.0, 0.0, 0.0, 0.0};
  const std::vector<double> simulated = {0.0, 0.0, 9.0, 0.0, 0.0, 0.0, 9.0, 0.0, 0.0};
  EXPECT_EQ(crossCorrelation({.simulated = simulated, .measured = measured}, 4).lag, 2.0);
  EXPECT_EQ(crossCorrelation({.simulated = measured, .measured = simulated}, 4).lag, 2.0);
}

// r(1) = r(2) = 34 over the norms, in whole numbers.
TEST(CrossCorrelation, PrefersTheNearerOfTwoEqualLags) {
  const std::vector<double> measured = {0.0, 0.0, 0.0, 0.0, 9.0, 0.0, 0.0, 0.0, 0.0};
  const std::vector<double> simulated = {0.0, 2.0, 0.0, 1.0, 1.0, 6.0, 6.0, 1.0, 1.0};
  EXPECT_EQ(crossCorrelation({.simulated = simulated, .measured = measured}, 8).lag, 1.0);
  EXPECT_EQ(crossCorrelation({.simulated = measured, .measured = simulated}, 8).lag, -1.0);
}

TEST(CrossCorrelation, IsBlindToOffsetAndGain) {
  const std::vector<double> measured = pulse(40, 20);
  std::vector<double> simulated = pulse(40, 23);
  for (double& y : simulated) y = 5.0 + 0.25 * y;
  const CrossCorrelation best = crossCorrelation({.simulated = simulated, .measured = measured});
  const std::vector<double> plain = pulse(40, 23);
  EXPECT_EQ(best.lag, 3.0);
  EXPECT_NEAR(best.maximum, crossCorrelation({.simulated = plain, .measured = measured}).maximum, 1e-14);
}

// a(1) of -1, 1, -1, 1 is -3/4, of -1, -1, 1, 1 it is 1/4: squares sum to 4, neighbouring products to -3 and 1.
TEST(AutocorrelationDifference, FollowsItsFormula) {
  const TwoSeries both = {.simulated = {-1.0, 1.0, -1.0, 1.0}, .measured = {-1.0, -1.0, 1.0, 1.0}};
  EXPECT_DOUBLE_EQ(autocorrelationDifference(both.pair(), 1), 1.0);
  EXPECT_DOUBLE_EQ(autocorrelationDifference(both.pair(), 2), (1.0 + 1.0) / 2.0);  // a(2) = 2/4 and -2/4
}

TEST(AutocorrelationDifference, IgnoresWhenAndHowLoud) {
  RandomSeries cases(125);
  for (int k = 0; k < 50; ++k) {
    const std::vector<double> measured = cases.series(cases.length(20, 60));
    std::vector<double> simulated(measured.rbegin(), measured.rend());
    for (double& y : simulated) y = 7.0 - 3.0 * y;
    EXPECT_NEAR(autocorrelationDifference({.simulated = simulated, .measured = measured}), 0.0, 1e-12);
  }
}

TEST(AutocorrelationDifference, SeesAnotherPeriod) {
  const std::vector<double> measured = wave(200, 20.0);
  const std::vector<double> same = wave(200, 20.0);
  const std::vector<double> slower = wave(200, 27.0);
  EXPECT_EQ(autocorrelationDifference({.simulated = same, .measured = measured}), 0.0);
  EXPECT_GT(autocorrelationDifference({.simulated = slower, .measured = measured}), 0.3);
}

TEST(AutocorrelationDifference, IsSymmetricAndAtMostTwo) {
  RandomSeries cases(126);
  for (int k = 0; k < 100; ++k) {
    const TwoSeries both = cases.two(cases.length(20, 60));
    EXPECT_EQ(autocorrelationDifference(both.pair()), autocorrelationDifference(both.exchanged()));
    EXPECT_LE(autocorrelationDifference(both.pair()), 2.0);
  }
}

TEST(LaggedCorrelations, OfAConstantSeriesAreUndefined) {
  const std::vector<double> moving = {1.0, 2.0, 4.0};
  const std::vector<double> constant(3, 0.1);
  const CrossCorrelation best = crossCorrelation({.simulated = constant, .measured = moving});
  EXPECT_TRUE(std::isnan(best.maximum));
  EXPECT_TRUE(std::isnan(best.lag));
  EXPECT_TRUE(std::isnan(autocorrelationDifference({.simulated = moving, .measured = constant})));
}

TEST(LaggedCorrelations, OfASingleValueAreUndefined) {
  const std::vector<double> one = {2.0};
  EXPECT_TRUE(std::isnan(crossCorrelation({.simulated = one, .measured = one}).maximum));
  EXPECT_TRUE(std::isnan(autocorrelationDifference({.simulated = one, .measured = one})));
}

TEST(LaggedCorrelations, RefuseLagsWithoutOverlap) {
  RandomSeries cases(127);
  const TwoSeries both = cases.two(20);
  EXPECT_EQ(thrownMessage([&] { (void)crossCorrelation(both.pair(), 19); }), "");
  EXPECT_NE(thrownMessage([&] { (void)crossCorrelation(both.pair(), 20); }).find("largest lag: is 20"),
            std::string::npos);
  EXPECT_NE(thrownMessage([&] { (void)autocorrelationDifference(both.pair(), 20); }), "");
  EXPECT_NE(thrownMessage([&] { (void)autocorrelationDifference(both.pair(), 0); }).find("is 0"), std::string::npos);
}

}  // namespace
