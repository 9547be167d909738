#include "metrics/distributions/confidence_band.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>

#include "core/error.h"
#include "core/random.h"
#include "metrics/distributions/box_bounds.h"
#include "metrics/distributions/level_walk.h"
#include "tests/metrics/random_cases.h"

namespace {

using metrics::confidenceBand;
using metrics::confidenceHalfWidth;
using metrics::Edf;
using metrics::Interval;
using metrics::PBox;
using metrics_test::RandomCases;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

// sqrt(ln(2/alpha) / (2 n)). The second is also the asymptotic critical value of a Kolmogorov-Smirnov test of
// n = m = 100, whose effective size is 50.
TEST(ConfidenceHalfWidth, IsTheClosedForm) {
  EXPECT_DOUBLE_EQ(confidenceHalfWidth(2.0, 2.0 * std::exp(-1.0)), 0.5);
  EXPECT_NEAR(confidenceHalfWidth(50.0, 0.05), 0.19206455826398416, 1e-16);
  EXPECT_DOUBLE_EQ(confidenceHalfWidth(400.0, 0.1), 0.5 * confidenceHalfWidth(100.0, 0.1));
}

// Four values, eps = 0.3: edges at F_n + 0.3 and F_n - 0.3, tails to 0 and 9.
TEST(ConfidenceBand, IsTheSampleMovedUpAndDownAndCut) {
  const double alpha = 2.0 * std::exp(-2.0 * 4.0 * 0.3 * 0.3);
  const PBox box = confidenceBand(Edf({1.0, 2.0, 3.0, 4.0}), alpha, {.low = 0.0, .high = 9.0});
  EXPECT_THAT(box.left().values(), ElementsAre(0.0, 1.0, 2.0, 3.0));
  EXPECT_THAT(box.right().values(), ElementsAre(2.0, 3.0, 4.0, 9.0));
  const double left[] = {0.3, 0.55, 0.8, 1.0};
  const double right[] = {0.2, 0.45, 0.7, 1.0};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(box.left().levels()[i], left[i], 1e-15);
    EXPECT_NEAR(box.right().levels()[i], right[i], 1e-15);
  }
}

TEST(ConfidenceBand, HasTheHeightOfTwoHalfWidthsWhereItIsNotCut) {
  RandomCases cases(100);
  for (int k = 0; k < 200; ++k) {
    const Edf edf = cases.edf(200);
    const PBox box = confidenceBand(edf, 0.1, {.low = -50.0, .high = 50.0});
    const double eps = confidenceHalfWidth(edf.effectiveN(), 0.1);
    EXPECT_TRUE(metrics::contains(box, edf));
    for (const double x : edf.values()) {
      EXPECT_NEAR(probabilityInterval(box, x).low, std::max(0.0, edf.cdf(x) - eps), 1e-15);
      EXPECT_NEAR(probabilityInterval(box, x).high, std::min(1.0, edf.cdf(x) + eps), 1e-15);
    }
  }
}

TEST(ConfidenceBand, OfTooFewValuesIsTheSupport) {
  const PBox box = confidenceBand(Edf({4.0}), 0.05, {.low = 0.0, .high = 9.0});
  EXPECT_THAT(box.left().values(), ElementsAre(0.0));
  EXPECT_THAT(box.right().values(), ElementsAre(9.0));
}

// Longer tails by t on either side: eps t more area each.
TEST(ConfidenceBand, GrowsByTheHalfWidthTimesTheTails) {
  const Edf edf(metrics_test::normalGrid(0.0, 1.0, 500));
  const double near = confidenceBand(edf, 0.05, {.low = -4.0, .high = 4.0}).area();
  const double far = confidenceBand(edf, 0.05, {.low = -5.0, .high = 7.0}).area();
  EXPECT_NEAR(far - near, 4.0 * confidenceHalfWidth(500.0, 0.05), 1e-12);
}

/// The identity on [0, 1] stays inside: p in [L(p), R(p)] at the worst end of every level.
bool holdsTheUniform(const PBox& box) {
  bool inside = true;
  metrics::eachCommonLevel<2>({&box.left(), &box.right()}, [&](const metrics::CommonLevel<2>& at) {
    inside = inside && at.quantiles[0] <= at.below && at.level <= at.quantiles[1];
  });
  return inside;
}

struct Coverage {
  std::size_t n;
  double alpha;
  double misses;  // exact: scipy 1.10.1, scipy.stats.kstwo.sf(sqrt(log(2 / alpha) / (2 * n)), n)
};

class UniformSamples : public testing::TestWithParam<Coverage> {};

// How often the band misses the uniform is the tail of Kolmogorov's statistic, known exactly for every n: below alpha,
// and near it already for n = 50. 20000 repetitions: four standard errors of a share.
TEST_P(UniformSamples, AreMissedAsOftenAsKolmogorovSays) {
  const auto [n, alpha, misses] = GetParam();
  constexpr int kRepetitions = 20000;
  core::Random random({.seed = 101, .sample = static_cast<std::uint32_t>(n)});
  int missed = 0;
  for (int k = 0; k < kRepetitions; ++k) {
    std::vector<double> values(n);
    for (double& x : values) x = random.uniform();
    if (!holdsTheUniform(confidenceBand(Edf(std::move(values)), alpha, {.low = 0.0, .high = 1.0}))) ++missed;
  }
  const double tolerance = 4.0 * std::sqrt(misses * (1.0 - misses) / kRepetitions);
  EXPECT_NEAR(static_cast<double>(missed) / kRepetitions, misses, tolerance);
  EXPECT_LT(misses, alpha);
}

INSTANTIATE_TEST_SUITE_P(ConfidenceBand, UniformSamples,
                         testing::Values(Coverage{.n = 5, .alpha = 0.2, .misses = 0.14120256340916848},
                                         Coverage{.n = 10, .alpha = 0.1, .misses = 0.07383607356280852},
                                         Coverage{.n = 50, .alpha = 0.1, .misses = 0.08842584420282373},
                                         Coverage{.n = 200, .alpha = 0.05, .misses = 0.04672919460299163}));

TEST(ConfidenceBand, OfWeightedValuesUsesTheirEffectiveNumber) {
  const Edf edf = Edf::weighted(std::vector{1.0, 2.0, 3.0}, std::vector{2.0, 1.0, 1.0});
  const PBox box = confidenceBand(edf, 0.9, {.low = 0.0, .high = 4.0});
  const double effective_n = 16.0 / 6.0;
  EXPECT_NEAR(probabilityInterval(box, 0.5).high, confidenceHalfWidth(effective_n, 0.9), 1e-15);
}

TEST(ConfidenceBand, RefusesUnboundedTailsAndDistributionsWithoutSample) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const auto band = [](Edf edf, double alpha, Interval support) {
    return [edf, alpha, support] { (void)confidenceBand(edf, alpha, support); };
  };
  const Edf edf({1.0, 2.0});
  EXPECT_THAT(band(edf, 0.1, {.low = 0.0, .high = inf}), ThrowsMessage<core::InputError>(HasSubstr("is not bounded")));
  EXPECT_THAT(band(edf, 0.1, {.low = nan, .high = 3.0}), ThrowsMessage<core::InputError>(HasSubstr("is not bounded")));
  EXPECT_THAT(band(edf, 0.1, {.low = 1.5, .high = 3.0}),
              ThrowsMessage<core::InputError>(HasSubstr("from 1 to 2, outside the support [1.5, 3]")));
  EXPECT_THAT(band(edf, 0.1, {.low = 0.0, .high = 1.5}), ThrowsMessage<core::InputError>(HasSubstr("outside")));
  for (const double alpha : {0.0, 1.0, nan}) {
    EXPECT_THAT(band(edf, alpha, {.low = 0.0, .high = 3.0}), ThrowsMessage<core::InputError>(HasSubstr("alpha is")));
  }
  EXPECT_THAT(band(Edf::fromSteps(std::vector{1.0}, std::vector{1.0}), 0.1, {.low = 0.0, .high = 3.0}),
              ThrowsMessage<core::InputError>(HasSubstr("without a sample")));
  EXPECT_THAT([] { (void)confidenceHalfWidth(0.0, 0.1); },
              ThrowsMessage<core::InputError>(HasSubstr("needs at least one")));
}

}  // namespace
