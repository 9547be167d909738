#include "metrics/sensitivity/sobol_indices.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/parallel.h"
#include "core/random.h"
#include "metrics/sensitivity/sensitivity_plan.h"
#include "tests/metrics/sensitivity/closed_forms.h"
#include "tests/support/thrown_message.h"

namespace {

using metrics::FirstOrderEstimator;
using metrics::SensitivityPlan;
using metrics::SensitivityResult;
using metrics::sobolIndices;
using metrics::SobolOptions;
using metrics::sobolPlan;
using metrics_test::GFunction;
using metrics_test::kIshigamiFirst;
using metrics_test::kIshigamiTotal;
using metrics_test::Model;
using metrics_test::outputsOf;
using metrics_test::parameters;

SensitivityResult indicesOf(const SensitivityPlan& plan, const Model& model, const SobolOptions& options = {}) {
  return sobolIndices(outputsOf(plan, model), plan.parameters.size(), plan.n, options);
}

// Quasi-random points err by about 1/n times a power of log n: at n = 4096 well below 1 % of the variance.
TEST(SobolIndices, OfTheIshigamiFunctionAreThoseInClosedForm) {
  const SensitivityPlan plan = sobolPlan(metrics_test::ishigamiParameters(), 4096, 1);
  for (const FirstOrderEstimator estimator : {FirstOrderEstimator::Saltelli, FirstOrderEstimator::Jansen}) {
    const SensitivityResult result = indicesOf(plan, metrics_test::ishigami, {.first_order = estimator});
    EXPECT_NEAR(result.mean, 3.5, 0.02);
    EXPECT_NEAR(result.variance, 13.844588, 0.1);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(result.parameters[i].first.value, kIshigamiFirst[i], 0.015) << i;
      EXPECT_NEAR(result.parameters[i].total.value, kIshigamiTotal[i], 0.015) << i;
    }
  }
}

TEST(SobolIndices, OfTheGFunctionAreThoseInClosedForm) {
  const GFunction g{{0.0, 1.0, 4.5, 9.0, 99.0, 99.0}};
  const SensitivityResult result = indicesOf(sobolPlan(parameters(6, 0.0, 1.0), 4096, 1), g);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(result.parameters[i].first.value, g.first(i), 0.015) << i;
    EXPECT_NEAR(result.parameters[i].total.value, g.total(i), 0.015) << i;
  }
}

// S_i = a_i^2 / sum a^2 and nothing interacts. Uniform inputs are met almost exactly by the net.
TEST(SobolIndices, OfALinearModelAreSquaredSlopes) {
  const auto model = [](const std::vector<double>& x) { return 1e6 + 3.0 * x[0] - 4.0 * x[1]; };
  const SensitivityResult result = indicesOf(sobolPlan(parameters(2, 0.0, 1.0), 1024, 1), model);
  EXPECT_NEAR(result.parameters[0].first.value, 9.0 / 25.0, 0.01);
  EXPECT_NEAR(result.parameters[1].first.value, 16.0 / 25.0, 0.01);
  EXPECT_NEAR(result.parameters[0].total.value, 9.0 / 25.0, 0.01);
  EXPECT_NEAR(result.variance, 25.0 / 12.0, 1e-3);
}

// Exact, not within an error: f_A = f_ABi.
TEST(SobolIndices, TotalOfAnInertParameterIsZero) {
  const auto model = [](const std::vector<double>& x) { return x[0] * x[2]; };
  const SensitivityResult result = indicesOf(sobolPlan(parameters(3, 0.0, 1.0), 32, 1), model);
  EXPECT_EQ(result.parameters[1].total.value, 0.0);
  EXPECT_EQ(result.parameters[1].total.low, 0.0);
  EXPECT_EQ(result.parameters[1].total.high, 0.0);
  EXPECT_EQ(result.parameters[1].first.value, 0.0);
}

TEST(SobolIndices, DoNotDependOnUnitAndOffsetOfTheOutput) {
  const SensitivityPlan plan = sobolPlan(metrics_test::ishigamiParameters(), 256, 1);
  const SensitivityResult metres = indicesOf(plan, metrics_test::ishigami);
  const SensitivityResult moved =
      indicesOf(plan, [](const std::vector<double>& x) { return 1e4 - 1000.0 * metrics_test::ishigami(x); });
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(moved.parameters[i].first.value, metres.parameters[i].first.value, 1e-10);
    EXPECT_NEAR(moved.parameters[i].total.high, metres.parameters[i].total.high, 1e-10);
  }
}

// 95 % intervals of 60 plans with different shifts. They take quasi-random rows for random ones, so they hold the
// truth at least as often: at most 3 + 3 deviations of 1.7 may miss.
TEST(SobolIndices, HaveIntervalsThatHoldTheTruth) {
  int missed = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const SensitivityResult result = indicesOf(sobolPlan(metrics_test::ishigamiParameters(), 256, seed),
                                               metrics_test::ishigami, {.replicates = 200});
    const metrics::SensitivityIndex& total = result.parameters[0].total;
    EXPECT_LT(total.low, total.value);
    EXPECT_GT(total.high, total.value);
    missed += total.low <= kIshigamiTotal[0] && kIshigamiTotal[0] <= total.high ? 0 : 1;
  }
  EXPECT_LE(missed, 8);
}

TEST(SobolIndices, AreTheSameForAnyNumberOfThreads) {
  const SensitivityPlan plan = sobolPlan(metrics_test::ishigamiParameters(), 64, 1);
  core::limitThreads(1);
  const SensitivityResult one = indicesOf(plan, metrics_test::ishigami);
  core::limitThreads(4);
  const SensitivityResult four = indicesOf(plan, metrics_test::ishigami);
  core::limitThreads(0);
  EXPECT_EQ(one.parameters[0].first.low, four.parameters[0].first.low);
  EXPECT_EQ(one.parameters[2].total.high, four.parameters[2].total.high);
}

TEST(SobolIndices, OfAConstantAreUndefined) {
  const SensitivityResult result =
      indicesOf(sobolPlan(parameters(2, 0.0, 1.0), 8, 1), [](const std::vector<double>&) { return 0.1; });
  EXPECT_DOUBLE_EQ(result.mean, 0.1);
  EXPECT_NEAR(result.variance, 0.0, 1e-30);
  EXPECT_TRUE(std::isnan(result.parameters[0].first.value));
}

TEST(SobolIndices, RefuseOutputsThatDoNotFitThePlan) {
  const auto message = [](const std::vector<double>& outputs) {
    return test_support::thrownMessage([&] { (void)sobolIndices(outputs, 1, 2); });
  };
  EXPECT_NE(message({1.0, 2.0, 3.0}).find("3 outputs for 1 parameters and n = 2"), std::string::npos);
  EXPECT_NE(message({1.0, 2.0, 3.0, NAN, 5.0, 6.0}).find("output 4"), std::string::npos);
}

}  // namespace
