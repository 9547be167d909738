#include "metrics/sensitivity/fast_indices.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/error.h"
#include "metrics/sensitivity/sensitivity_plan.h"
#include "tests/metrics/sensitivity/closed_forms.h"

namespace {

using metrics::fastIndices;
using metrics::fastPlan;
using metrics::SensitivityPlan;
using metrics::SensitivityResult;
using metrics_test::GFunction;
using metrics_test::kIshigamiFirst;
using metrics_test::kIshigamiTotal;
using metrics_test::Model;
using metrics_test::outputsOf;
using metrics_test::parameters;

SensitivityResult indicesOf(const SensitivityPlan& plan, const Model& model) {
  return fastIndices(outputsOf(plan, model), plan.parameters.size(), plan.n, plan.curves);
}

// Saltelli et al. 1999 cut the spectrum after four harmonics: errors of a few per cent are the method's own.
// OpenTURNS 1.20, FAST with 400 points: first 0.307, 0.445, 0.000, total 0.555, 0.488, 0.239.
TEST(FastIndices, OfTheIshigamiFunctionAreThoseInClosedForm) {
  const SensitivityResult result =
      indicesOf(fastPlan(metrics_test::ishigamiParameters(), 1025, 4, 1), metrics_test::ishigami);
  EXPECT_NEAR(result.mean, 3.5, 0.05);
  EXPECT_NEAR(result.variance, 13.84, 0.4);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(result.parameters[i].first.value, kIshigamiFirst[i], 0.03) << i;
    EXPECT_NEAR(result.parameters[i].total.value, kIshigamiTotal[i], 0.05) << i;
    EXPECT_LE(result.parameters[i].first.low, result.parameters[i].first.value);
    EXPECT_GE(result.parameters[i].total.high, result.parameters[i].total.value);
  }
}

TEST(FastIndices, OfTheGFunctionAreThoseInClosedForm) {
  const GFunction g{{0.0, 1.0, 4.5, 9.0}};
  const SensitivityResult result = indicesOf(fastPlan(parameters(4, 0.0, 1.0), 1025, 4, 1), g);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(result.parameters[i].first.value, g.first(i), 0.03) << i;
    EXPECT_NEAR(result.parameters[i].total.value, g.total(i), 0.05) << i;
  }
}

// A triangle wave has harmonics 1, 3, 5, … with powers 1/p^4; the first four hold (1 + 1/81) / (pi^4 / 96) of it.
TEST(FastIndices, OfALinearModelMissOnlyWhatLiesPastTheFourthHarmonic) {
  const auto model = [](const std::vector<double>& x) { return 3.0 * x[0] - 4.0 * x[1]; };
  const SensitivityResult result = indicesOf(fastPlan(parameters(2, 0.0, 1.0), 2049, 2, 1), model);
  const double held = (1.0 + 1.0 / 81.0) * 96.0 / std::pow(std::numbers::pi, 4.0);
  EXPECT_NEAR(result.parameters[0].first.value, held * 9.0 / 25.0, 0.003);
  EXPECT_NEAR(result.parameters[1].first.value, held * 16.0 / 25.0, 0.003);
}

TEST(FastIndices, OfAnInertParameterAreAlmostZero) {
  const auto model = [](const std::vector<double>& x) { return x[0] * x[2]; };
  const SensitivityResult result = indicesOf(fastPlan(parameters(3, 0.0, 1.0), 1025, 2, 1), model);
  EXPECT_NEAR(result.parameters[1].first.value, 0.0, 0.005);
  EXPECT_NEAR(result.parameters[1].total.value, 0.0, 0.02);
}

TEST(FastIndices, OfOneCurveHaveNoInterval) {
  const SensitivityResult result =
      indicesOf(fastPlan(metrics_test::ishigamiParameters(), 257, 1, 1), metrics_test::ishigami);
  EXPECT_TRUE(std::isnan(result.parameters[0].first.low));
  EXPECT_TRUE(std::isfinite(result.parameters[0].first.value));
}

TEST(FastIndices, OfAConstantAreUndefined) {
  const SensitivityResult result =
      indicesOf(fastPlan(parameters(2, 0.0, 1.0), 65, 2, 1), [](const std::vector<double>&) { return 5.0; });
  EXPECT_EQ(result.variance, 0.0);
  EXPECT_TRUE(std::isnan(result.parameters[1].total.value));
}

TEST(FastIndices, RefuseOutputsThatDoNotFitThePlan) {
  EXPECT_THROW((void)fastIndices(std::vector<double>(64, 1.0), 1, 65, 1), core::InputError);
  EXPECT_THROW((void)fastIndices(std::vector<double>(64, 1.0), 1, 64, 1), core::InputError);
  EXPECT_THROW((void)fastIndices(std::vector<double>(65, NAN), 1, 65, 1), core::InputError);
  EXPECT_THROW((void)fastIndices(std::vector<double>(65, 1.0), 1, 65, 1, 0.0), core::InputError);
}

}  // namespace
