#include "metrics/samples/kolmogorov_smirnov.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

#include "tests/metrics/random_cases.h"

namespace {

using metrics::Edf;
using metrics::KolmogorovSmirnov;
using metrics::kolmogorovSmirnovTest;
using metrics_test::RandomCases;

/// 0 … n-1, and the same moved by `steps` ranks and half a rank: the CDFs differ by steps/n at most.
KolmogorovSmirnov ofMovedRanks(int n, double steps) {
  std::vector<double> ranks(static_cast<std::size_t>(n));
  std::iota(ranks.begin(), ranks.end(), 0.0);
  const Edf measured(ranks);
  const Edf simulated = measured.shifted(steps - 0.5);
  return kolmogorovSmirnovTest({.simulated = simulated, .measured = measured});
}

// MATLAB's kstest2, n = m = 100 (the form that reproduces Rosenberger 2022, Tab. 8-4).
TEST(KolmogorovSmirnov, HasTheAsymptoticPValueOfStephens) {
  EXPECT_DOUBLE_EQ(ofMovedRanks(100, 16.0).statistic, 0.16);
  EXPECT_NEAR(ofMovedRanks(100, 16.0).p_value, 0.13997518016385863, 1e-12);
  EXPECT_NEAR(ofMovedRanks(100, 6.0).p_value, 0.9921018394783477, 1e-12);
}

TEST(KolmogorovSmirnov, EqualSamplesHavePOneAndDisjointOnesNearlyNone) {
  const Edf edf({1.0, 2.0, 3.0});
  const KolmogorovSmirnov same = kolmogorovSmirnovTest({.simulated = edf, .measured = edf});
  EXPECT_EQ(same.statistic, 0.0);
  EXPECT_EQ(same.p_value, 1.0);
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
  EXPECT_TRUE(std::isnan(kolmogorovSmirnovTest({.simulated = table, .measured = Edf({1.0})}).p_value));
}

}  // namespace
