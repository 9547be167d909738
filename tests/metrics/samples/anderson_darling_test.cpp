#include "metrics/samples/anderson_darling.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/metrics/random_cases.h"
#include "tests/metrics/samples/reference.h"

namespace {

using metrics::AndersonDarling;
using metrics::andersonDarlingPermutationTest;
using metrics::andersonDarlingTail;
using metrics::andersonDarlingTest;
using metrics::andersonDarlingToFittedNormal;
using metrics::andersonDarlingToNormal;
using metrics::AndersonDarlingToNormal;
using metrics::Edf;
using metrics_test::RandomCases;

// By hand: both values have mid-ranks 1/2 and 3/2, each adds 1/2 to the sum, and (N - 1)/N (1/n + 1/m) = 1.
TEST(AndersonDarling, OfTwoDistinctValuesIsOne) {
  EXPECT_DOUBLE_EQ(andersonDarlingTest({.simulated = Edf({0.0}), .measured = Edf({1.0})}).statistic, 1.0);
}

TEST(AndersonDarling, ReproducesScipy) {
  for (const auto& test : metrics_test::samplesReference()["two_samples"]) {
    const Edf simulated = metrics_test::edfOf(test["simulated"]);
    const Edf measured = metrics_test::edfOf(test["measured"]);
    const AndersonDarling ours = andersonDarlingTest({.simulated = simulated, .measured = measured});
    EXPECT_NEAR(ours.standardised, test["ad_standardised"].get<double>(), 1e-11) << test["name"];
    // scipy interpolates the table by one parabola in log p, good to some 4 %, and stops at 0.1 % and 25 %.
    const double p = test["ad_p"];
    if (p == 0.25) {
      EXPECT_GT(ours.p_value, 0.24) << test["name"];
    } else if (p == 0.001) {
      EXPECT_LT(ours.p_value, 0.00105) << test["name"];
    } else {
      EXPECT_NEAR(ours.p_value, p, 0.04 * p) << test["name"];
    }
  }
}

// Percentiles of the standardised limit for two samples: Scholz & Stephens 1987, Tab. 1, from approximate fits. The
// 1 % point of the limit is 3.878 and not the old 3.857 behind 3.752, which costs 2.4 % of p.
TEST(AndersonDarling, TailMeetsTheTableOfScholzAndStephens) {
  const double deviation = std::sqrt(2.0 * (std::acos(-1.0) * std::acos(-1.0) - 9.0) / 3.0);
  for (const auto& [p, t] : {std::pair{0.25, 0.326}, std::pair{0.10, 1.225}, std::pair{0.05, 1.960},
                             std::pair{0.025, 2.719}, std::pair{0.01, 3.752}}) {
    EXPECT_NEAR(andersonDarlingTail(1.0 + deviation * t), p, 0.025 * p) << p;
  }
}

TEST(AndersonDarling, TailIsTheSeriesOfAndersonAndDarling) {
  for (const auto& pair : metrics_test::samplesReference()["ad_tail"]) {
    EXPECT_NEAR(andersonDarlingTail(pair[0]), pair[1].get<double>(), 1e-10);
  }
}

// Far out the largest term, chi^2/2, rules: P = sqrt(3) erfc(sqrt z) (1 + O(exp(-2z))), the other terms adding the
// factor prod_{j >= 2} (1 - 2/(j (j + 1)))^(-1/2) = sqrt 3 to leading order in 1/z.
TEST(AndersonDarling, TailDecaysAsItsLargestTerm) {
  double before = 1.0;
  for (const double z : {20.0, 60.0, 180.0, 540.0}) {
    const double excess = std::abs(andersonDarlingTail(z) / (std::sqrt(3.0) * std::erfc(std::sqrt(z))) - 1.0);
    EXPECT_LT(excess, 1.0 / z);
    EXPECT_LT(excess, before);
    before = excess;
  }
}

TEST(AndersonDarling, TailFallsFromOne) {
  double before = 1.0;
  for (double z = 0.01; z < 30.0; z *= 1.1) {
    const double tail = andersonDarlingTail(z);
    EXPECT_LE(tail, before + 1e-15);
    before = tail;
  }
  EXPECT_EQ(andersonDarlingTail(0.0), 1.0);
  EXPECT_EQ(andersonDarlingTail(-3.0), 1.0);
}

TEST(AndersonDarling, IsSymmetricAndBlindToShiftAndScale) {
  RandomCases cases(80);
  for (int k = 0; k < 200; ++k) {
    const std::vector<double> x = cases.sample();
    const std::vector<double> y = cases.sample();
    const double statistic = andersonDarlingTest({.simulated = Edf(x), .measured = Edf(y)}).statistic;
    EXPECT_NEAR(andersonDarlingTest({.simulated = Edf(y), .measured = Edf(x)}).statistic, statistic, 1e-10);
    const auto moved = [](std::vector<double> values) {
      for (double& v : values) v = 4.0 * v + 8.0;  // exact: no new ties
      return Edf(values);
    };
    EXPECT_NEAR(andersonDarlingTest({.simulated = moved(x), .measured = moved(y)}).statistic, statistic, 1e-10);
  }
}

TEST(AndersonDarling, HasNoPValueWhereNothingCanDiffer) {
  EXPECT_TRUE(std::isnan(andersonDarlingTest({.simulated = Edf({1.0, 1.0}), .measured = Edf({1.0, 1.0})}).p_value));
  EXPECT_TRUE(std::isnan(andersonDarlingTest({.simulated = Edf({1.0}), .measured = Edf({2.0})}).p_value));
  const Edf table = Edf::fromSteps(std::vector{1.0, 2.0}, std::vector{0.5, 1.0});
  EXPECT_TRUE(std::isnan(andersonDarlingTest({.simulated = table, .measured = Edf({1.0, 2.0, 3.0})}).statistic));
}

// A valid p-value is uniform. 2000 equal pairs: the share below 10 % has a standard error of 0.7 %.
TEST(AndersonDarling, PValueOfEqualDistributionsIsUniform) {
  core::Random random({.seed = 81});
  const auto sample = [&random](std::size_t n) {
    std::vector<double> values(n);
    for (double& x : values) x = random.normal();
    return Edf(values);
  };
  int below_tenth = 0;
  int below_half = 0;
  for (int k = 0; k < 2000; ++k) {
    const double p = andersonDarlingTest({.simulated = sample(30), .measured = sample(50)}).p_value;
    below_tenth += p <= 0.1 ? 1 : 0;
    below_half += p <= 0.5 ? 1 : 0;
  }
  EXPECT_NEAR(below_tenth / 2000.0, 0.1, 4 * 0.007);
  EXPECT_NEAR(below_half / 2000.0, 0.5, 4 * 0.0112);
}

// With 9999 shuffles the standard error of p is sqrt(p (1 - p) / 9999); the limit form is off by some 5 % of p at n
// = 45.
TEST(AndersonDarlingPermutation, AgreesWithTheLimitWhereThereAreNoTies) {
  for (const auto& test : metrics_test::samplesReference()["two_samples"]) {
    const Edf simulated = metrics_test::edfOf(test["simulated"]);
    const Edf measured = metrics_test::edfOf(test["measured"]);
    if (measured.n() < 45) continue;  // few values, or ties
    const double limit = andersonDarlingTest({.simulated = simulated, .measured = measured}).p_value;
    const double p = andersonDarlingPermutationTest({.simulated = simulated, .measured = measured}, 9999).p_value;
    EXPECT_NEAR(p, limit, 4.0 * std::sqrt(limit * (1 - limit) / 9999) + 0.05 * limit + 1e-4) << test["name"];
  }
}

// 2 of the C(6, 3) = 20 orders keep three and three apart; all other statistics are smaller.
TEST(AndersonDarlingPermutation, OfThreeAndThreeApartIsOneInTen) {
  const AndersonDarling test =
      andersonDarlingPermutationTest({.simulated = Edf({1.0, 2.0, 3.0}), .measured = Edf({4.0, 5.0, 6.0})}, 9999);
  EXPECT_NEAR(test.p_value, 0.1, 4.0 * 0.003);
}

TEST(AndersonDarlingPermutation, SameSeedSameResultAndEqualValuesGiveOne) {
  const Edf x({0.0, 0.0, 1.0, 2.0, 2.0});
  const Edf y({0.0, 1.0, 1.0, 3.0});
  const auto p = [&](std::uint64_t seed) {
    return andersonDarlingPermutationTest({.simulated = x, .measured = y}, 99, seed).p_value;
  };
  EXPECT_EQ(p(5), p(5));
  EXPECT_EQ(andersonDarlingPermutationTest({.simulated = Edf({1.0, 1.0}), .measured = Edf({1.0})}, 99).p_value, 1.0);
}

TEST(AndersonDarlingPermutation, RefusesWhatItCannotShuffle) {
  const Edf plain({1.0, 2.0});
  const Edf weighted = Edf::weighted(std::vector{1.0, 2.0}, std::vector{1.0, 3.0});
  EXPECT_THROW((void)andersonDarlingPermutationTest({.simulated = weighted, .measured = plain}), core::InputError);
  EXPECT_THROW((void)andersonDarlingPermutationTest({.simulated = plain, .measured = plain}, 0), core::InputError);
}

// One value at the mean: both tails are 1/2.
TEST(AndersonDarlingToNormal, OfOneValueAtTheMeanIsTwoLogTwoMinusOne) {
  EXPECT_NEAR(andersonDarlingToNormal(Edf({3.0}), {.mean = 3.0, .deviation = 2.0}).statistic, 2.0 * std::log(2.0) - 1.0,
              1e-15);
}

// Textbook sum with scipy's log cdf and log sf; the far sample lies 22 to 30 deviations out.
TEST(AndersonDarlingToNormal, ReproducesTheTextbookSum) {
  const auto& reference = metrics_test::samplesReference()["ad_to_normal"];
  const Edf simulated = metrics_test::edfOf(reference["simulated"]);
  const Edf measured = metrics_test::edfOf(reference["measured"]);
  const double far = reference["statistic"];
  EXPECT_NEAR(andersonDarlingToFittedNormal({.simulated = simulated, .measured = measured}).statistic, far,
              1e-11 * far);
  EXPECT_NEAR(andersonDarlingToNormal(measured, {.mean = 22.0, .deviation = 0.2}).statistic,
              reference["near"].get<double>(), 1e-12);
}

// 1 - cdf rounds to 0 near 8.29 deviations (the last bit of erfc decides) above the mean, and nowhere below it.
TEST(AndersonDarlingToNormal, PublishedFormIsInfiniteFarAboveTheMeanOnly) {
  const auto of = [](double z) { return andersonDarlingToNormal(Edf({z}), {.mean = 0.0, .deviation = 1.0}); };
  EXPECT_TRUE(std::isfinite(of(8.28).as_published));
  EXPECT_EQ(of(8.28).rounded_off, 0u);
  EXPECT_TRUE(std::isinf(of(8.31).as_published));
  EXPECT_EQ(of(8.31).rounded_off, 1u);
  EXPECT_TRUE(std::isfinite(of(-30.0).as_published));
  // Far out -log(1 - cdf) -> z^2/2 + log z + log(2 pi)/2, and log cdf -> 0.
  EXPECT_NEAR(of(100.0).statistic, 5000.0 + std::log(100.0) + 0.5 * std::log(2.0 * std::acos(-1.0)) - 1.0, 2e-4);
  EXPECT_NEAR(of(-100.0).statistic, of(100.0).statistic, 1e-9);
  EXPECT_NEAR(of(3.0).as_published, of(3.0).statistic, 1e-10);
}

TEST(AndersonDarlingToNormal, WeightsAreRepetitions) {
  const Edf repeated({1.0, 1.0, 1.0, 2.0, 4.0, 4.0});
  const Edf weighted = Edf::weighted(std::vector{1.0, 2.0, 4.0}, std::vector{3.0, 1.0, 2.0});
  const metrics::Normal normal{.mean = 2.0, .deviation = 1.5};
  EXPECT_NEAR(andersonDarlingToNormal(repeated, normal).statistic / 6.0,
              andersonDarlingToNormal(weighted, normal).statistic / weighted.effectiveN(), 1e-14);
}

// E[A^2] = 1 under the null, whatever n; its standard deviation is 0.76. 2000 repetitions: standard error 0.017.
TEST(AndersonDarlingToNormal, HasMeanOneForItsOwnNormal) {
  core::Random random({.seed = 82});
  double sum = 0.0;
  for (int k = 0; k < 2000; ++k) {
    std::vector<double> values(20);
    for (double& x : values) x = 5.0 + 3.0 * random.normal();
    sum += andersonDarlingToNormal(Edf(values), {.mean = 5.0, .deviation = 3.0}).statistic;
  }
  EXPECT_NEAR(sum / 2000.0, 1.0, 4 * 0.017);
}

TEST(AndersonDarlingToNormal, RefusesANormalWithoutSpread) {
  EXPECT_THROW((void)andersonDarlingToFittedNormal({.simulated = Edf({1.0}), .measured = Edf({2.0})}),
               core::InputError);
  EXPECT_THROW((void)andersonDarlingToFittedNormal({.simulated = Edf({1.0}), .measured = Edf({2.0, 2.0})}),
               core::InputError);
}

}  // namespace
