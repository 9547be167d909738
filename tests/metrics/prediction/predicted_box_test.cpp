#include "metrics/prediction/predicted_box.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "metrics/area/double_validation_metric.h"
#include "metrics/distributions/propagation.h"
#include "tests/metrics/random_cases.h"

namespace {

using metrics::BoundOf;
using metrics::Edf;
using metrics::PBox;
using metrics::predictedBox;
using metrics::PredictedBox;
using metrics::PredictedError;
using metrics_test::RandomCases;
using testing::ElementsAre;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

PredictedError known(double value, double half_width = 0.0) {
  return {.value = value,
          .confidence = {value - half_width, value + half_width},
          .observation = {value - 2.0 * half_width, value + 2.0 * half_width}};
}

/// The inner box lies within the outer one at every level.
void expectInside(const PBox& inner, const PBox& outer) {
  for (int i = 1; i < 40; ++i) {
    const double p = i / 40.0;
    EXPECT_GE(inner.left().quantile(p), outer.left().quantile(p) - 1e-12);
    EXPECT_LE(inner.right().quantile(p), outer.right().quantile(p) + 1e-12);
  }
}

TEST(PredictedBox, SimulationTooHighMovesDown) {
  const PBox simulated = Edf({10.0, 12.0});
  const PredictedBox box = predictedBox(simulated, {.bias = known(0.5), .scatter = known(0.25)});
  EXPECT_THAT(box.expected.left().values(), ElementsAre(9.25, 11.25));
  EXPECT_THAT(box.expected.right().values(), ElementsAre(9.75, 11.75));
}

TEST(PredictedBox, BoundTakesBothErrorsAtTheirBounds) {
  const PBox simulated = Edf({10.0, 12.0});
  const PredictedError bias = known(0.5, 0.125);
  const PredictedError scatter = known(0.25, 0.0625);
  const PredictedBox box = predictedBox(simulated, {.bias = bias, .scatter = scatter});
  EXPECT_THAT(box.bound->left().values(), ElementsAre(10.0 - 0.625 - 0.3125, 12.0 - 0.625 - 0.3125));
  EXPECT_THAT(box.bound->right().values(), ElementsAre(10.0 - 0.375 + 0.3125, 12.0 - 0.375 + 0.3125));
  const PredictedBox wider = predictedBox(simulated, {.bias = bias, .scatter = scatter}, BoundOf::Observation);
  EXPECT_THAT(wider.bound->left().values(), ElementsAre(10.0 - 0.75 - 0.375, 12.0 - 0.75 - 0.375));
}

TEST(PredictedBox, OfAPerfectPredictionOfAPureOffsetIsTheMeasurement) {
  RandomCases cases(90);
  for (int k = 0; k < 50; ++k) {
    const Edf measured = cases.edf();
    const PBox simulated = measured.shifted(0.75);
    const PBox real = measured;
    const auto dvm = metrics::doubleValidationMetric({.simulated = simulated, .measured = real});
    const PBox expected = predictedBox(simulated, {.bias = known(dvm.bias), .scatter = known(dvm.scatter)}).expected;
    expectInside(real, expected);
    EXPECT_NEAR(expected.area(), 0.0, 1e-12);
  }
}

TEST(PredictedBox, BoundHoldsTheExpectedBoxAndEveryErrorBetween) {
  RandomCases cases(91);
  for (int k = 0; k < 50; ++k) {
    const PBox simulated = cases.box();
    const PredictedError bias = known(cases.uniform(-1, 1), cases.uniform(0, 1));
    const PredictedError scatter = known(1.0, cases.uniform(0, 1));
    const PredictedBox box = predictedBox(simulated, {.bias = bias, .scatter = scatter});
    expectInside(box.expected, *box.bound);
    const double b = cases.uniform(bias.confidence.low, bias.confidence.high);
    const double s = cases.uniform(0.0, scatter.confidence.high);
    expectInside(metrics::widened(simulated.shifted(-b), {.below = s, .above = s}), *box.bound);
  }
}

TEST(PredictedBox, WithoutFiniteBoundsThereIsNoBoundBox) {
  const PBox simulated = Edf({1.0});
  PredictedError bias = known(0.5);
  bias.confidence = {-kInfinity, kInfinity};
  EXPECT_FALSE(predictedBox(simulated, {.bias = bias, .scatter = known(0.0)}).bound);
}

}  // namespace
