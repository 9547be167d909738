#include "metrics/series/correlation.h"

#include <cmath>
#include <gtest/gtest.h>

#include "tests/metrics/series/random_series.h"
#include "tests/support/thrown_message.h"

namespace {

using metrics::coefficientOfDetermination;
using metrics::pearsonCorrelation;
using metrics::SeriesPair;
using metrics::whyUncorrelated;
using metrics_test::RandomSeries;
using metrics_test::TwoSeries;
using test_support::thrownMessage;

std::vector<double> scaled(const std::vector<double>& series, double gain, double offset) {
  std::vector<double> result;
  for (const double x : series) result.push_back(offset + gain * x);
  return result;
}

/// Noise that differs from value to value, so that it has a correlation.
std::vector<double> varied(RandomSeries& cases, std::size_t n) {
  std::vector<double> series = cases.series(n);
  series.front() = series.back() + 1.0;
  return series;
}

TEST(PearsonCorrelation, OfALinearRelationIsTheSignOfItsGain) {
  RandomSeries cases(111);
  for (int k = 0; k < 100; ++k) {
    const std::vector<double> measured = varied(cases, cases.length(2, 30));
    const double gain = cases.uniform(0.1, 4.0);
    const std::vector<double> rising = scaled(measured, gain, cases.uniform(-9.0, 9.0));
    const std::vector<double> falling = scaled(measured, -gain, cases.uniform(-9.0, 9.0));
    EXPECT_NEAR(pearsonCorrelation({.simulated = rising, .measured = measured}), 1.0, 1e-13);
    EXPECT_NEAR(pearsonCorrelation({.simulated = falling, .measured = measured}), -1.0, 1e-13);
  }
}

TEST(PearsonCorrelation, OfOrthogonalDeviationsIsZero) {
  const TwoSeries both = {.simulated = {2.0, 2.0, 4.0, 4.0}, .measured = {1.0, 3.0, 1.0, 3.0}};
  EXPECT_EQ(pearsonCorrelation(both.pair()), 0.0);
}

TEST(PearsonCorrelation, IsSymmetricAndBoundedByOne) {
  RandomSeries cases(112);
  for (int k = 0; k < 200; ++k) {
    const std::size_t n = cases.length(2, 20);
    const TwoSeries both = {.simulated = varied(cases, n), .measured = varied(cases, n)};
    EXPECT_LE(std::abs(pearsonCorrelation(both.pair())), 1.0);
    EXPECT_NEAR(pearsonCorrelation(both.pair()), pearsonCorrelation(both.exchanged()), 1e-15);
  }
}

// 0/0: neither 0 ("no relation") nor 1 ("equal"). The mean of three times 0.1 is not 0.1, so that a variance would be
// rounding noise: constancy is asked of the values.
TEST(Correlations, OfAConstantSeriesAreUndefinedForAStatedReason) {
  const std::vector<double> moving = {1.0, 2.0, 4.0};
  const std::vector<double> constant(3, 0.1);
  const SeriesPair simulated_constant = {.simulated = constant, .measured = moving};
  const SeriesPair measured_constant = {.simulated = moving, .measured = constant};
  const SeriesPair both_constant = {.simulated = constant, .measured = constant};
  EXPECT_EQ(whyUncorrelated(simulated_constant), "the simulated series is constant");
  EXPECT_EQ(whyUncorrelated(measured_constant), "the measured series is constant");
  EXPECT_EQ(whyUncorrelated(both_constant), "both series are constant");
  EXPECT_FALSE(whyUncorrelated({.simulated = moving, .measured = moving}).has_value());
  for (const SeriesPair& pair : {simulated_constant, measured_constant, both_constant}) {
    EXPECT_TRUE(std::isnan(pearsonCorrelation(pair)));
  }
}

TEST(Correlations, OfASingleValueAreUndefined) {
  const std::vector<double> one = {1.0};
  EXPECT_TRUE(std::isnan(pearsonCorrelation({.simulated = one, .measured = one})));
  EXPECT_TRUE(std::isnan(coefficientOfDetermination({.simulated = one, .measured = one})));
}

TEST(Correlations, RefuseSeriesThatDoNotPair) {
  const std::vector<double> one = {1.0};
  const std::vector<double> two = {1.0, 2.0};
  for (const auto metric : {pearsonCorrelation, coefficientOfDetermination}) {
    EXPECT_NE(thrownMessage([&] { (void)metric({.simulated = one, .measured = two}); }), "");
  }
}

TEST(CoefficientOfDetermination, IsOneForEqualAndZeroForTheMean) {
  const std::vector<double> measured = {1.0, 2.0, 6.0};
  const std::vector<double> mean = {3.0, 3.0, 3.0};
  EXPECT_EQ(coefficientOfDetermination({.simulated = measured, .measured = measured}), 1.0);
  EXPECT_NEAR(coefficientOfDetermination({.simulated = mean, .measured = measured}), 0.0, 1e-15);
}

// y = x + b: 1 - n b^2 / (n s^2). Unlike r it sees the offset, and falls below 0 once b exceeds s.
TEST(CoefficientOfDetermination, OfAnOffsetFallsWithItsSquare) {
  const std::vector<double> measured = {-1.0, 1.0, -1.0, 1.0};  // s = 1
  for (const double offset : {0.0, 0.5, 1.0, 3.0}) {
    const std::vector<double> simulated = scaled(measured, 1.0, offset);
    EXPECT_DOUBLE_EQ(coefficientOfDetermination({.simulated = simulated, .measured = measured}), 1.0 - offset * offset);
  }
}

TEST(CoefficientOfDetermination, NeedsAMeasurementThatMoves) {
  const std::vector<double> moving = {1.0, 2.0};
  const std::vector<double> constant = {1.5, 1.5};
  EXPECT_TRUE(std::isnan(coefficientOfDetermination({.simulated = moving, .measured = constant})));
  EXPECT_EQ(coefficientOfDetermination({.simulated = constant, .measured = moving}), 0.0);
}

}  // namespace
