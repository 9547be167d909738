#include "metrics/area/area_metric.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "metrics/samples/wasserstein.h"
#include "tests/metrics/random_cases.h"

namespace {

using metrics::AreaPortions;
using metrics::areaPortions;
using metrics::areaValidationMetric;
using metrics::Edf;
using metrics::PBox;
using metrics_test::normalGrid;
using metrics_test::RandomCases;
using metrics_test::widened;

double area(const PBox& simulated, const PBox& measured) {
  return areaValidationMetric({.simulated = simulated, .measured = measured});
}

/// The definition read literally, along the values: areas between CDF bounds, one cell after the other.
AreaPortions slowPortions(const PBox& simulated, const PBox& measured) {
  std::vector<double> x;
  for (const Edf* edge : {&simulated.left(), &simulated.right(), &measured.left(), &measured.right()}) {
    x.insert(x.end(), edge->values().begin(), edge->values().end());
  }
  std::sort(x.begin(), x.end());
  AreaPortions portions{0.0, 0.0};
  for (std::size_t i = 1; i < x.size(); ++i) {
    const double cell = x[i] - x[i - 1];
    portions.d_plus += cell * std::max(0.0, simulated.right().cdf(x[i - 1]) - measured.left().cdf(x[i - 1]));
    portions.d_minus += cell * std::max(0.0, measured.right().cdf(x[i - 1]) - simulated.left().cdf(x[i - 1]));
  }
  return portions;
}

// Up to 60 steps of size 10: 1e-12 is some hundred roundings.
TEST(AreaMetric, PortionsAreTheAreasBetweenTheCdfBounds) {
  RandomCases cases(10);
  for (int k = 0; k < 1000; ++k) {
    const PBox simulated = cases.box();
    const PBox measured = cases.box(k % 2 == 0 ? 1 : 4);
    const AreaPortions portions = areaPortions({.simulated = simulated, .measured = measured});
    const AreaPortions expected = slowPortions(simulated, measured);
    EXPECT_NEAR(portions.d_plus, expected.d_plus, 1e-12);
    EXPECT_NEAR(portions.d_minus, expected.d_minus, 1e-12);
  }
}

TEST(AreaMetric, OfTwoSamplesIsTheirWassersteinDistance) {
  RandomCases cases(11);
  for (int k = 0; k < 500; ++k) {
    const Edf simulated = cases.edf();
    const Edf measured = cases.edf();
    EXPECT_NEAR(area(simulated, measured), metrics::wassersteinDistance({.simulated = simulated, .measured = measured}),
                1e-12);
  }
}

TEST(AreaMetric, OfTwoSamplesHasTheDifferenceOfMeansAsBias) {
  RandomCases cases(12);
  for (int k = 0; k < 500; ++k) {
    const Edf simulated = cases.edf();
    const std::vector<double> values = cases.sample();
    std::vector<double> weights;
    for (std::size_t i = 0; i < values.size(); ++i) weights.push_back(cases.uniform(0.1, 2.0));
    const Edf measured = Edf::weighted(values, weights);
    const AreaPortions portions = areaPortions({.simulated = simulated, .measured = measured});
    EXPECT_NEAR(portions.bias(), simulated.mean() - measured.mean(), 1e-12);
    EXPECT_GE(portions.area(), std::abs(portions.bias()) - 1e-12);
  }
}

TEST(AreaMetric, ExchangedSidesExchangeThePortions) {
  RandomCases cases(15);
  for (int k = 0; k < 200; ++k) {
    const PBox a = cases.box();
    const PBox b = cases.box();
    const AreaPortions forth = areaPortions({.simulated = a, .measured = b});
    const AreaPortions back = areaPortions({.simulated = b, .measured = a});
    EXPECT_DOUBLE_EQ(forth.d_plus, back.d_minus);
    EXPECT_DOUBLE_EQ(forth.d_minus, back.d_plus);
  }
}

TEST(AreaMetric, OfAShiftedCopyIsTheShift) {
  RandomCases cases(16);
  for (int k = 0; k < 200; ++k) {
    const Edf measured = cases.edf();
    const double b = cases.uniform(-5.0, 5.0);
    const AreaPortions portions = areaPortions({.simulated = measured.shifted(b), .measured = measured});
    EXPECT_NEAR(portions.d_plus, std::max(0.0, -b), 1e-13);
    EXPECT_NEAR(portions.d_minus, std::max(0.0, b), 1e-13);
  }
}

// Rounding every slice to the data's own digits would lose this one: values in mm, moved by 4 mm.
TEST(AreaMetric, SmallShiftOfRoundedDataIsNotLost) {
  std::vector<double> values;
  for (int i = 0; i < 1000; ++i) values.push_back(22.0 + 0.001 * (i * 37 % 211));
  const Edf measured(values);
  EXPECT_NEAR(area(measured.shifted(0.004), measured), 0.004, 1e-14);
}

// Quantiles differ by |ds| |z|, and E|z| = sqrt(2/pi). The grid of n quantiles cuts the tails: error below 1/n.
TEST(AreaMetric, OfNormalsWithOneMeanIsTheDifferenceOfSpreads) {
  const int n = 100000;
  EXPECT_NEAR(area(Edf(normalGrid(22.0, 0.6, n)), Edf(normalGrid(22.0, 0.2, n))),
              0.4 * std::sqrt(2.0 / std::numbers::pi), 1e-5);
}

// E|b + ds Z|, a folded normal: ds sqrt(2/pi) exp(-b^2/(2 ds^2)) + |b| (1 - 2 Phi(-|b|/ds)); b = 0.5, ds = 0.4.
TEST(AreaMetric, OfTwoNormalsIsTheMeanOfAFoldedNormal) {
  const int n = 200000;
  EXPECT_NEAR(area(Edf(normalGrid(22.5, 0.6, n)), Edf(normalGrid(22.0, 0.2, n))), 0.5404694946443622, 1e-6);
}

TEST(AreaMetric, OfEqualSampleSizesIsTheMeanDistanceOfSortedValues) {
  RandomCases cases(17);
  for (int k = 0; k < 100; ++k) {
    std::vector<double> a = cases.sample();
    std::vector<double> b = cases.sample();
    const std::size_t n = std::min(a.size(), b.size());
    a.resize(n);
    b.resize(n);
    const double metric = area(Edf(a), Edf(b));
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    double sum = 0.0;
    for (std::size_t i = 0; i < n; ++i) sum += std::abs(a[i] - b[i]);
    EXPECT_NEAR(metric, sum / static_cast<double>(n), 1e-13);
  }
}

// Uniform on (0, 1) and (0, 2): quantiles p and 2 p.
TEST(AreaMetric, OfTwoUniformsIsHalf) {
  std::vector<double> narrow;
  std::vector<double> wide;
  for (int i = 0; i < 1000; ++i) {
    narrow.push_back((i + 0.5) / 1000.0);
    wide.push_back((i + 0.5) / 500.0);
  }
  const Edf simulated(wide);
  const Edf measured(narrow);
  const AreaPortions portions = areaPortions({.simulated = simulated, .measured = measured});
  EXPECT_NEAR(portions.d_minus, 0.5, 1e-12);
  EXPECT_EQ(portions.d_plus, 0.0);
}

// scipy.stats.wasserstein_distance, examples of its documentation, scipy 1.10.1.
TEST(AreaMetric, ReproducesScipy) {
  const auto weighted = [](std::vector<double> x, std::vector<double> w) { return Edf::weighted(x, w); };
  EXPECT_DOUBLE_EQ(area(Edf({0.0, 1.0, 3.0}), Edf({5.0, 6.0, 8.0})), 5.0);
  EXPECT_DOUBLE_EQ(area(weighted({0.0, 1.0}, {3.0, 1.0}), weighted({0.0, 1.0}, {2.0, 2.0})), 0.25);
  EXPECT_NEAR(area(weighted({3.4, 3.9, 7.5, 7.8}, {1.4, 0.9, 3.1, 7.2}), weighted({4.5, 1.4}, {3.2, 3.5})),
              4.078133143804786, 1e-14);
}

// pyvale (MIT), lattice of its modified area metric: the simulation is too high by 3.
TEST(AreaMetric, ReproducesTheLatticeOfPyvale) {
  const Edf simulated({2.0, 3.0});
  const Edf measured({-2.0, -1.0, 0.0, 1.0});
  const AreaPortions portions = areaPortions({.simulated = simulated, .measured = measured});
  EXPECT_DOUBLE_EQ(portions.d_plus, 0.0);
  EXPECT_DOUBLE_EQ(portions.d_minus, 3.0);
}

// A box S = F + c, widened by +-w: only what the shift exceeds the width by remains.
TEST(AreaMetric, WidthOfABoxExcusesAShiftUpToIt) {
  RandomCases cases(18);
  for (int k = 0; k < 200; ++k) {
    const Edf measured = cases.edf();
    const double c = cases.uniform(-2.0, 2.0);
    const double w = cases.uniform(0.0, 2.0);
    const AreaPortions portions = areaPortions({.simulated = widened(measured.shifted(c), w), .measured = measured});
    const double expected = std::max(0.0, std::abs(c) - w);
    EXPECT_NEAR(portions.area(), expected, 1e-13);
    EXPECT_NEAR(portions.bias(), std::copysign(expected, c), 1e-13);
  }
}

// Danquah's identity: AVM(F, [L, R]) = (W1(F, L) + W1(F, R) - W1(L, R)) / 2.
TEST(AreaMetric, OfABoxFollowsFromTheDistancesToItsEdges) {
  RandomCases cases(19);
  for (int k = 0; k < 300; ++k) {
    const PBox box = cases.box();
    const Edf measured = cases.edf();
    const double expected = 0.5 * (area(box.left(), measured) + area(box.right(), measured) - box.area());
    EXPECT_NEAR(area(box, measured), expected, 1e-12);
    EXPECT_NEAR(area(measured, box), expected, 1e-12);
  }
}

TEST(AreaMetric, NumberAboveAnIntervalMeansSimulationTooLow) {
  const PBox interval = PBox::fromInterval(2.0, 5.0);
  const PBox seven = Edf({7.0});
  const AreaPortions portions = areaPortions({.simulated = interval, .measured = seven});
  EXPECT_EQ(portions.d_plus, 2.0);
  EXPECT_EQ(portions.d_minus, 0.0);
  EXPECT_EQ(portions.bias(), -2.0);
}

TEST(AreaMetric, WiderBoxNeverHasTheLargerArea) {
  RandomCases cases(20);
  for (int k = 0; k < 200; ++k) {
    std::vector<Edf> runs = cases.runs();
    const Edf measured = cases.edf();
    const double before = area(PBox::envelope(runs), measured);
    runs.push_back(cases.edf());
    EXPECT_LE(area(PBox::envelope(runs), measured), before + 1e-13);
  }
}

}  // namespace
