#include "metrics/samples/kolmogorov_smirnov.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

#include "tests/metrics/random_cases.h"
#include "tests/metrics/samples/reference.h"

namespace {

using metrics::Edf;
using metrics::KolmogorovSmirnov;
using metrics::kolmogorovSmirnovTest;
using metrics::KsPValue;
using metrics_test::RandomCases;

std::vector<double> ranks(int n, double first = 0.0) {
  std::vector<double> values(static_cast<std::size_t>(n));
  std::iota(values.begin(), values.end(), first);
  return values;
}

/// 0 … n-1, and the same moved by `steps` ranks and half a rank: the CDFs differ by steps/n at most.
KolmogorovSmirnov ofMovedRanks(int n, double steps, KsPValue method = KsPValue::Stephens) {
  const Edf measured(ranks(n));
  const Edf simulated = measured.shifted(steps - 0.5);
  return kolmogorovSmirnovTest({.simulated = simulated, .measured = measured}, method);
}

double binomial(int n, int k) {
  return std::round(std::exp(std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1)));
}

// MATLAB's kstest2, n = m = 100 (the form that reproduces Rosenberger 2022, Tab. 8-4).
TEST(KolmogorovSmirnov, HasTheAsymptoticPValueOfStephens) {
  EXPECT_DOUBLE_EQ(ofMovedRanks(100, 16.0).statistic, 0.16);
  EXPECT_NEAR(ofMovedRanks(100, 16.0).p_value, 0.13997518016385863, 1e-12);
  EXPECT_NEAR(ofMovedRanks(100, 6.0).p_value, 0.9921018394783477, 1e-12);
}

// The critical value 0.19206 for n = m = 100, alpha = 5 %, that goes with these p-values in print is that of the
// UNCORRECTED asymptotic form, 2 exp(-2 N D^2) = alpha. With Stephens' correction D = 0.19 is rejected already.
TEST(KolmogorovSmirnov, RejectsBelowTheUncorrectedCriticalValue) {
  const double critical = 0.19206455826398416;
  EXPECT_NEAR(2.0 * std::exp(-2.0 * 50.0 * critical * critical), 0.05, 1e-15);
  EXPECT_LT(ofMovedRanks(100, 19.0).statistic, critical);
  EXPECT_LT(ofMovedRanks(100, 19.0).p_value, 0.05);
  EXPECT_GT(ofMovedRanks(100, 18.0).p_value, 0.05);
}

TEST(KolmogorovSmirnov, EqualSamplesHavePOneAndDisjointOnesNearlyNone) {
  const Edf edf({1.0, 2.0, 3.0});
  for (const KsPValue method : {KsPValue::Stephens, KsPValue::ExactIfSmall}) {
    const KolmogorovSmirnov same = kolmogorovSmirnovTest({.simulated = edf, .measured = edf}, method);
    EXPECT_EQ(same.statistic, 0.0);
    EXPECT_EQ(same.p_value, 1.0);
  }
  const KolmogorovSmirnov apart = ofMovedRanks(1000, 1000.5);
  EXPECT_EQ(apart.statistic, 1.0);
  EXPECT_LT(apart.p_value, 1e-100);
}

TEST(KolmogorovSmirnov, StatisticIsTheLargestDistanceOfTheCdfs) {
  RandomCases cases(70);
  for (int k = 0; k < 300; ++k) {
    const Edf simulated = cases.edf();
    const Edf measured = cases.edf();
    double largest = 0.0;
    for (const Edf* edf : {&simulated, &measured}) {
      for (const double x : edf->values()) largest = std::max(largest, std::abs(simulated.cdf(x) - measured.cdf(x)));
    }
    EXPECT_EQ(kolmogorovSmirnovTest({.simulated = simulated, .measured = measured}).statistic, largest);
  }
}

TEST(KolmogorovSmirnov, FunctionWithoutASampleHasNoPValue) {
  const Edf table = Edf::fromSteps(std::vector{1.0, 2.0}, std::vector{0.5, 1.0});
  for (const KsPValue method : {KsPValue::Stephens, KsPValue::ExactIfSmall}) {
    EXPECT_TRUE(std::isnan(kolmogorovSmirnovTest({.simulated = table, .measured = Edf({1.0})}, method).p_value));
  }
}

// Of the C(n + m, n) orders of n + m distinct values two keep the samples apart.
TEST(ExactKolmogorovSmirnov, OfDisjointSamplesIsTwoOrdersOfAll) {
  for (int n = 1; n <= 12; ++n) {
    for (int m = 1; m <= 12; ++m) {
      const KolmogorovSmirnov test =
          kolmogorovSmirnovTest({.simulated = Edf(ranks(n)), .measured = Edf(ranks(m, 100.0))}, KsPValue::ExactIfSmall);
      EXPECT_NEAR(test.p_value * binomial(n + m, n), 2.0, 1e-9) << n << " " << m;
    }
  }
}

// Every order of n + m distinct values is tried: the p-values are the tail of the distribution so found.
TEST(ExactKolmogorovSmirnov, IsTheShareOfAllOrders) {
  for (const auto& [n, m] : {std::pair{5, 5}, std::pair{4, 6}, std::pair{3, 7}, std::pair{6, 4}, std::pair{1, 9}}) {
    std::vector<KolmogorovSmirnov> tests;
    std::vector<int> labels(static_cast<std::size_t>(n + m), 0);
    std::fill(labels.begin() + n, labels.end(), 1);
    do {
      std::vector<double> simulated;
      std::vector<double> measured;
      for (std::size_t i = 0; i < labels.size(); ++i) {
        (labels[i] == 0 ? simulated : measured).push_back(static_cast<double>(i));
      }
      tests.push_back(
          kolmogorovSmirnovTest({.simulated = Edf(simulated), .measured = Edf(measured)}, KsPValue::ExactIfSmall));
    } while (std::next_permutation(labels.begin(), labels.end()));
    for (const KolmogorovSmirnov& test : tests) {
      const auto as_far = std::count_if(tests.begin(), tests.end(), [&](const KolmogorovSmirnov& other) {
        return other.statistic >= test.statistic - 1e-12;
      });
      EXPECT_NEAR(test.p_value, static_cast<double>(as_far) / static_cast<double>(tests.size()), 1e-12);
    }
  }
}

TEST(ExactKolmogorovSmirnov, ReproducesScipy) {
  for (const auto& test : metrics_test::samplesReference()["two_samples"]) {
    const Edf simulated = metrics_test::edfOf(test["simulated"]);
    const Edf measured = metrics_test::edfOf(test["measured"]);
    const KolmogorovSmirnov ours =
        kolmogorovSmirnovTest({.simulated = simulated, .measured = measured}, KsPValue::ExactIfSmall);
    const double p = test["ks_exact_p"];
    EXPECT_NEAR(ours.statistic, test["ks"].get<double>(), 1e-14) << test["name"];
    EXPECT_NEAR(ours.p_value, p, 1e-10 * p) << test["name"];
    EXPECT_EQ(ours.method, KsPValue::ExactIfSmall);
  }
}

// D comes in steps of 1/3000, over which p changes by 4 lambda sqrt(N)/n = 7 %; the smooth form passes within half a
// step. n m = 9e6 is just below the limit of the exact form, 1e10 far above.
TEST(ExactKolmogorovSmirnov, MeetsTheAsymptoticFormInTheLimit) {
  const KolmogorovSmirnov exact = ofMovedRanks(3000, 105.0, KsPValue::ExactIfSmall);
  EXPECT_EQ(exact.method, KsPValue::ExactIfSmall);
  EXPECT_NEAR(exact.p_value / ofMovedRanks(3000, 105.0).p_value, 1.0, 0.035);
  const KolmogorovSmirnov large = ofMovedRanks(100000, 605.0, KsPValue::ExactIfSmall);
  EXPECT_EQ(large.method, KsPValue::Stephens);
  EXPECT_EQ(large.p_value, ofMovedRanks(100000, 605.0).p_value);
}

TEST(KolmogorovSmirnov, CountsTies) {
  const Edf distinct({1.0, 2.0, 3.0, 4.0});
  const Edf other({1.5, 2.5, 3.5, 4.5});
  EXPECT_EQ(kolmogorovSmirnovTest({.simulated = distinct, .measured = other}).tie_share, 0.0);
  EXPECT_FALSE(kolmogorovSmirnovTest({.simulated = distinct, .measured = other}).heavy_ties);
  const Edf counter({1.0, 1.0, 2.0, 2.0});  // three repeat in itself or in `distinct`: 1, 1, 2, 2 of 8
  EXPECT_EQ(kolmogorovSmirnovTest({.simulated = counter, .measured = distinct}).tie_share, 0.5);
  EXPECT_TRUE(kolmogorovSmirnovTest({.simulated = counter, .measured = distinct}).heavy_ties);
}

// Why the flag: two normals, rounded to half a deviation, n = m = 50. A valid test at 10 % would reject 10 % of 2000
// equal pairs (standard error 0.7 %); with these ties it rejects far fewer.
TEST(KolmogorovSmirnov, HeavyTiesMakeThePValueTooLarge) {
  core::Random random({.seed = 71});
  const auto counter = [&random] {
    std::vector<double> values(50);
    for (double& x : values) x = 0.5 * std::round(2.0 * random.normal());
    return Edf(values);
  };
  int rejected = 0;
  for (int k = 0; k < 2000; ++k) {
    const KolmogorovSmirnov test =
        kolmogorovSmirnovTest({.simulated = counter(), .measured = counter()}, KsPValue::ExactIfSmall);
    EXPECT_TRUE(test.heavy_ties);
    rejected += test.p_value <= 0.10 ? 1 : 0;
  }
  EXPECT_LT(rejected, 2000 * (0.10 - 4 * 0.007));
}

}  // namespace
