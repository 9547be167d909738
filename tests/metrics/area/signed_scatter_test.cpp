#include "metrics/area/signed_scatter.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "tests/metrics/random_cases.h"

namespace {

using metrics::doubleValidationMetric;
using metrics::Edf;
using metrics::PBox;
using metrics::Shift;
using metrics::signedScatter;
using metrics_test::normalGrid;
using metrics_test::RandomCases;
using metrics_test::widened;

double signedOf(const PBox& simulated, const PBox& measured, Shift shift = Shift::One) {
  return signedScatter({.simulated = simulated, .measured = measured}, shift);
}

double scatterOf(const PBox& simulated, const PBox& measured, Shift shift = Shift::One) {
  return doubleValidationMetric({.simulated = simulated, .measured = measured}, shift).scatter;
}

/// E|X - median(X)|
double meanDeviation(const Edf& edf) {
  double sum = 0.0;
  double below = 0.0;
  for (std::size_t i = 0; i < edf.values().size(); ++i) {
    sum += (edf.levels()[i] - below) * std::abs(edf.values()[i] - edf.median());
    below = edf.levels()[i];
  }
  return sum;
}

TEST(SignedScatter, OfSamplesIsTheDifferenceOfTheirMeanDeviations) {
  RandomCases cases(130);
  for (int k = 0; k < 500; ++k) {
    const Edf simulated = cases.edf();
    const Edf measured = cases.edf();
    EXPECT_NEAR(signedOf(simulated, measured), meanDeviation(simulated) - meanDeviation(measured), 1e-12);
  }
}

// Quantiles differ by (s_sim - s_real) z, and E|z| = sqrt(2/pi). The grid of n quantiles cuts the tails: below 1/n.
TEST(SignedScatter, OfNormalsIsTheDifferenceOfSpreads) {
  const Edf narrow(normalGrid(22.0, 0.2, 100000));
  const Edf wide(normalGrid(25.0, 0.6, 100000));
  const double expected = 0.4 * std::sqrt(2.0 / std::numbers::pi);
  EXPECT_NEAR(signedOf(wide, narrow), expected, 1e-5);
  EXPECT_NEAR(signedOf(narrow, wide), -expected, 1e-5);
  EXPECT_NEAR(scatterOf(wide, narrow), expected, 1e-5);
}

TEST(SignedScatter, IsNeverLargerThanTheScatter) {
  RandomCases cases(131);
  for (int k = 0; k < 1000; ++k) {
    const PBox simulated = cases.box();
    const PBox measured = cases.box(k % 2 == 0 ? 1 : 4);
    for (const Shift shift : {Shift::One, Shift::Balanced}) {
      EXPECT_LE(std::abs(signedOf(simulated, measured, shift)), scatterOf(simulated, measured, shift) + 1e-12);
    }
  }
}

TEST(SignedScatter, OfExchangedSidesHasTheOtherSign) {
  RandomCases cases(132);
  for (int k = 0; k < 300; ++k) {
    const PBox a = cases.box();
    const PBox b = cases.box();
    EXPECT_NEAR(signedOf(a, b), -signedOf(b, a), 1e-12);
  }
}

// The sides are far apart on both sides of the shift, so that boxes with width are met as well.
TEST(SignedScatter, OfSamplesAndOfBalancedBoxesIsIndependentOfOffsets) {
  RandomCases cases(133);
  for (int k = 0; k < 300; ++k) {
    const double offset = cases.uniform(-40.0, 40.0);
    const Edf sample = cases.edf();
    const Edf measured = cases.edf();
    EXPECT_NEAR(signedOf(sample.shifted(offset), measured), signedOf(sample, measured), 1e-11);
    EXPECT_NEAR(signedOf(sample, measured.shifted(offset)), signedOf(sample, measured), 1e-11);
    const PBox box = cases.box();
    const PBox real = cases.box(2);
    const double there = signedOf(box, real, Shift::Balanced);
    EXPECT_NEAR(signedOf(box.shifted(offset), real, Shift::Balanced), there, 1e-10);
    EXPECT_NEAR(signedOf(box, real.shifted(offset), Shift::Balanced), there, 1e-10);
  }
}

TEST(SignedScatter, OfACoveredMeasurementIsNone) {
  EXPECT_EQ(signedOf(PBox::fromInterval(0.0, 10.0), Edf({3.0, 8.0})), 0.0);
  EXPECT_EQ(signedOf(Edf({3.0, 8.0}), PBox::fromInterval(0.0, 10.0)), 0.0);
}

// {-4, 4} +- 1 against {0}: at each level 3 stay uncovered. The other way round the simulation is too narrow by 3.
TEST(SignedScatter, OfABoxCountsWhatItDoesNotCover) {
  const PBox wide = widened(Edf({-4.0, 4.0}), 1.0);
  EXPECT_EQ(signedOf(wide, Edf({0.0})), 3.0);
  EXPECT_EQ(signedOf(Edf({0.0}), wide), -3.0);
  EXPECT_EQ(signedOf(wide, PBox::fromInterval(-1.0, 1.0)), 2.0);
}

// Equally wide, other shape: mirrored skew has scatter and no sign. Medians 0 and 0, mean deviations 1 and 1.
TEST(SignedScatter, OfAnotherShapeOfEqualWidthIsNoneWhereTheScatterIsNot) {
  const Edf skewed({-1.0, -1.0, 0.0, 0.0, 0.0, 4.0});
  const Edf mirrored({-4.0, 0.0, 0.0, 0.0, 1.0, 1.0});
  EXPECT_NEAR(signedOf(skewed, mirrored), 0.0, 1e-15);
  EXPECT_GT(scatterOf(skewed, mirrored), 0.5);
}

TEST(SignedScatter, SplitsALevelThatHoldsTheMedian) {
  EXPECT_EQ(signedOf(Edf({5.0}), Edf({0.0})), 0.0);
  EXPECT_NEAR(signedOf(Edf({-3.0, 0.0, 3.0}), Edf({1.0})), 2.0, 1e-15);
}

}  // namespace
