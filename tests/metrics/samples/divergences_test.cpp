#include "metrics/samples/divergences.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "core/error.h"
#include "tests/metrics/random_cases.h"
#include "tests/metrics/samples/reference.h"

namespace {

using metrics::divergences;
using metrics::Divergences;
using metrics::Edf;
using metrics::histogramDivergences;
using metrics::InformationUnit;
using metrics::kdeBandwidth;
using metrics::kdeDivergences;
using metrics_test::normalGrid;
using metrics_test::RandomCases;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Divergences of(std::vector<double> measured, std::vector<double> simulated,
               InformationUnit unit = InformationUnit::Bit) {
  return divergences({.simulated = simulated, .measured = measured}, unit);
}

// scipy's documentation of entropy and jensenshannon.
TEST(Divergences, HaveTheClosedFormsOfSmallExamples) {
  EXPECT_DOUBLE_EQ(of({0.5, 0.5}, {0.9, 0.1}).kl, std::log2(5.0 / 3.0));  // (log2(5/9) + log2(5)) / 2
  EXPECT_DOUBLE_EQ(of({1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}).js_distance, 1.0);
  EXPECT_DOUBLE_EQ(of({1.0, 0.0}, {0.5, 0.5}, InformationUnit::Nat).js_distance, 0.46450140402245893);
  EXPECT_DOUBLE_EQ(of({1.0, 0.0}, {0.5, 0.5}).kl, 1.0);  // one bit too many for a certain event
}

TEST(Divergences, ReproduceScipy) {
  for (const auto& test : metrics_test::samplesReference()["discrete"]) {
    const std::vector<double> p = test["measured"];
    const std::vector<double> q = test["simulated"];
    const Divergences bit = of(p, q);
    const Divergences nat = of(p, q, InformationUnit::Nat);
    EXPECT_NEAR(bit.kl, test["kl_bit"].get<double>(), 1e-14);
    EXPECT_NEAR(nat.kl, test["kl_nat"].get<double>(), 1e-14);
    const double reverse = metrics_test::numberOf(test["kl_reverse_bit"]);
    if (std::isinf(reverse)) {
      EXPECT_EQ(bit.kl_reverse, reverse);
    } else {
      EXPECT_NEAR(bit.kl_reverse, reverse, 1e-14);
    }
    EXPECT_NEAR(bit.js_distance, test["js_distance_bit"].get<double>(), 1e-14);
    EXPECT_NEAR(nat.js_distance, test["js_distance_nat"].get<double>(), 1e-14);
  }
}

// Summed over the common cells only, these two would have the "divergence" 0.5 log2(0.5 / 0.9) = -0.42 bit.
TEST(Divergences, MissingSupportIsInfiniteNotNegative) {
  const Divergences result = of({0.5, 0.5, 0.0}, {0.9, 0.0, 0.1});
  EXPECT_EQ(result.kl, kInfinity);
  EXPECT_EQ(result.kl_reverse, kInfinity);
  EXPECT_EQ(result.symmetrised, kInfinity);
  EXPECT_LT(result.js, 1.0);
  EXPECT_EQ(of({1.0, 0.0}, {0.5, 0.5}).kl_reverse, kInfinity);
}

TEST(Divergences, AreZeroForEqualAndPositiveForOtherCells) {
  RandomCases cases(90);
  for (int k = 0; k < 300; ++k) {
    std::vector<double> p(6);
    std::vector<double> q(6);
    for (double& x : p) x = cases.uniform(0.0, 1.0);
    for (double& x : q) x = cases.uniform(0.0, 1.0);
    const Divergences same = of(p, p);
    EXPECT_EQ(same.kl, 0.0);
    EXPECT_EQ(same.js, 0.0);
    const Divergences other = of(p, q);
    EXPECT_GT(other.kl, 0.0);
    EXPECT_GT(other.js, 0.0);
    EXPECT_LE(other.js, 1.0);
    EXPECT_LE(other.js, other.symmetrised / 2.0 + 1e-12);  // Lin 1991: JS <= Jeffreys / 4
    EXPECT_NEAR(of(q, p).js, other.js, 1e-14);
    EXPECT_EQ(of(q, p).kl, other.kl_reverse);
    EXPECT_NEAR(of(p, q, InformationUnit::Nat).kl, other.kl * std::log(2.0), 1e-14);
  }
}

TEST(Divergences, JensenShannonDistanceObeysTheTriangleInequality) {
  RandomCases cases(91);
  const auto random = [&cases] {
    std::vector<double> p(4);
    for (double& x : p) x = std::max(0.0, cases.uniform(-0.5, 1.0));
    p[0] += 0.01;
    return p;
  };
  for (int k = 0; k < 1000; ++k) {
    const auto a = random();
    const auto b = random();
    const auto c = random();
    EXPECT_LE(of(a, c).js_distance, of(a, b).js_distance + of(b, c).js_distance + 1e-12);
  }
}

TEST(Divergences, TinyProbabilitiesDoNotOverflow) {
  const Divergences result = of({1.0, 1e-300}, {1e-300, 1.0});
  EXPECT_NEAR(result.kl, 300.0 * std::log2(10.0), 1e-9);
  EXPECT_NEAR(result.js, 1.0, 1e-15);
}

TEST(Divergences, RefuseWhatIsNoDistribution) {
  EXPECT_THROW((void)of({0.5, 0.5}, {1.0}), core::InputError);
  EXPECT_THROW((void)of({0.0, 0.0}, {0.5, 0.5}), core::InputError);
  EXPECT_THROW((void)of({}, {}), core::InputError);
  EXPECT_THROW((void)of({-0.5, 1.5}, {0.5, 0.5}), core::InputError);
  EXPECT_THROW((void)of({0.5, 0.5}, {std::nan(""), 0.5}), core::InputError);
  try {
    (void)of({0.5, 0.5, -1.0}, {0.5, 0.5, 0.0});
    FAIL();
  } catch (const core::InputError& error) {
    EXPECT_EQ(error.place().item, "measured cell 3");
  }
}

TEST(HistogramDivergences, CountInHalfOpenBins) {
  const Edf measured({0.0, 0.5, 1.0, 2.0});    // 2, 2 in [0, 1), [1, 2]
  const Edf simulated({0.0, 0.9, 0.99, 1.5});  // 3, 1
  const std::vector<double> edges = {0.0, 1.0, 2.0};
  const Divergences result = histogramDivergences({.simulated = simulated, .measured = measured}, edges);
  const Divergences counts = of({2.0, 2.0}, {3.0, 1.0});
  EXPECT_DOUBLE_EQ(result.kl, counts.kl);
  EXPECT_DOUBLE_EQ(result.kl_reverse, counts.kl_reverse);
  EXPECT_DOUBLE_EQ(result.js, counts.js);
}

TEST(HistogramDivergences, RefuseBinsThatLoseValues) {
  const Edf sample({0.0, 3.0});
  const auto with = [&](std::vector<double> edges) {
    return histogramDivergences({.simulated = sample, .measured = sample}, edges);
  };
  EXPECT_NO_THROW((void)with({0.0, 3.0}));
  EXPECT_THROW((void)with({0.0, 2.9}), core::InputError);
  EXPECT_THROW((void)with({0.1, 3.0}), core::InputError);
  EXPECT_THROW((void)with({0.0, 0.0, 3.0}), core::InputError);
  EXPECT_THROW((void)with({3.0, 0.0}), core::InputError);
  EXPECT_THROW((void)with({0.0}), core::InputError);
  EXPECT_THROW((void)with({0.0, std::nan(""), 3.0}), core::InputError);
}

// Of a normal the MAD is 0.6745 sigma.
TEST(KdeBandwidth, OfANormalIsTheReferenceRule) {
  EXPECT_NEAR(kdeBandwidth(Edf(normalGrid(22.0, 0.2, 1000))), 1.06 * 0.2 * std::pow(1000.0, -0.2), 2e-4);
  EXPECT_DOUBLE_EQ(kdeBandwidth(Edf({1.0, 2.0, 4.0, 8.0})),  // median 3, distances 1, 1, 2, 5: MAD 1.5
                   1.06 * 1.5 / 0.674489750196081743 * std::pow(4.0, -0.2));
  EXPECT_EQ(kdeBandwidth(Edf({1.0, 1.0, 1.0, 2.0})), 0.0);
}

// scipy's gaussian_kde with the same bandwidths on the same places, then entropy and jensenshannon.
TEST(KdeDivergences, ReproduceScipy) {
  for (const auto& test : metrics_test::samplesReference()["two_samples"]) {
    const Edf simulated = metrics_test::edfOf(test["simulated"]);
    const Edf measured = metrics_test::edfOf(test["measured"]);
    const Divergences ours = kdeDivergences({.simulated = simulated, .measured = measured});
    EXPECT_NEAR(ours.kl, test["kde_kl_bit"].get<double>(), 1e-9) << test["name"];
    EXPECT_NEAR(ours.kl_reverse, test["kde_kl_reverse_bit"].get<double>(), 1e-9) << test["name"];
    EXPECT_NEAR(ours.js_distance, test["kde_js_distance_bit"].get<double>(), 1e-9) << test["name"];
  }
}

// A Gaussian kernel of width h turns N(mu, s) into N(mu, sqrt(s^2 + h^2)), and two normals b apart have
// KL = b^2/(2 (s^2 + h^2)). 4000 quantiles stand for the normals; their tails, cut at 3.7 s, cost some per cent.
TEST(KdeDivergences, ApproachTheClosedFormOfShiftedNormals) {
  const Edf measured(normalGrid(0.0, 1.0, 4000));
  const Edf simulated = measured.shifted(0.5);
  const double expected = 0.125 / (1.0 + std::pow(kdeBandwidth(measured), 2));
  const Divergences result = kdeDivergences({.simulated = simulated, .measured = measured}, InformationUnit::Nat);
  EXPECT_NEAR(result.kl, expected, 0.03 * expected);
  EXPECT_NEAR(result.kl_reverse, expected, 0.03 * expected);
}

TEST(KdeDivergences, AreBlindToShiftAndScaleAndSymmetricInJs) {
  RandomCases cases(92);
  for (int k = 0; k < 50; ++k) {
    std::vector<double> x(40);
    std::vector<double> y(40);
    for (double& v : x) v = cases.uniform(0.0, 1.0);
    for (double& v : y) v = cases.uniform(0.2, 1.5);
    const auto moved = [](std::vector<double> values) {
      for (double& v : values) v = 4.0 * v + 8.0;
      return Edf(values);
    };
    const Divergences here = kdeDivergences({.simulated = Edf(x), .measured = Edf(y)});
    const Divergences there = kdeDivergences({.simulated = moved(x), .measured = moved(y)});
    EXPECT_NEAR(there.kl, here.kl, 1e-9 * here.kl);
    EXPECT_NEAR(kdeDivergences({.simulated = Edf(y), .measured = Edf(x)}).js, here.js, 1e-12);
  }
}

TEST(KdeDivergences, OfSamplesFarApartReadEnoughPlaces) {
  const Edf here(normalGrid(0.0, 1.0, 50));
  const Divergences result = kdeDivergences({.simulated = here.shifted(10000.0), .measured = here});
  EXPECT_EQ(result.kl, kInfinity);
  EXPECT_NEAR(result.js, 1.0, 1e-12);
}

TEST(KdeDivergences, RefuseSamplesWithoutABandwidth) {
  const Edf counter({1.0, 1.0, 1.0, 2.0});
  const Edf plain({1.0, 2.0, 3.0});
  EXPECT_THROW((void)kdeDivergences({.simulated = counter, .measured = plain}), core::InputError);
  EXPECT_THROW((void)kdeDivergences({.simulated = plain, .measured = Edf({1.0})}), core::InputError);
  EXPECT_THROW((void)kdeDivergences({.simulated = plain, .measured = plain}, InformationUnit::Bit, 1),
               core::InputError);
  EXPECT_THROW((void)kdeDivergences({.simulated = plain.shifted(1e9), .measured = plain}), core::InputError);
}

}  // namespace
