#include "metrics/prediction/aggregation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/metrics/prediction/error_cases.h"
#include "tests/metrics/random_cases.h"

namespace {

using metrics::aggregate;
using metrics::AggregatedUncertainty;
using metrics::areaPortions;
using metrics::Edf;
using metrics::Margin;
using metrics::modelFormOf;
using metrics::PBox;
using metrics_test::RandomCases;
using testing::ElementsAre;

// d- is by how much the simulation is too high: reality may be lower, so the left edge moves. d+ the other way.
TEST(Aggregation, OfAnEdfShiftsEachEdgeByItsPartExactly) {
  const PBox input = Edf({10.0, 11.0, 13.0});
  const AggregatedUncertainty box =
      aggregate({.input = input, .model_form = modelFormOf({.d_plus = 0.25, .d_minus = 1.0}), .numerical = 0.5});
  EXPECT_THAT(box.total.left().values(), ElementsAre(8.5, 9.5, 11.5));
  EXPECT_THAT(box.total.right().values(), ElementsAre(10.75, 11.75, 13.75));
  EXPECT_THAT(box.with_model_form.left().values(), ElementsAre(9.0, 10.0, 12.0));
  EXPECT_DOUBLE_EQ(box.total.area(), 0.25 + 1.0 + 2.0 * 0.5);
}

TEST(Aggregation, SimulationTooHighReachesToSmallerValuesAndHoldsTheMeasurement) {
  const PBox measured = Edf({20.0, 21.0});
  const PBox simulated = Edf({20.5, 21.5});
  const auto portions = areaPortions({.simulated = simulated, .measured = measured});
  const PBox total = aggregate({.input = simulated, .model_form = modelFormOf(portions)}).total;
  EXPECT_THAT(total.left().values(), ElementsAre(20.0, 21.0));
  EXPECT_THAT(total.right().values(), ElementsAre(20.5, 21.5));
  EXPECT_EQ(metrics::areaValidationMetric({.simulated = total, .measured = measured}), 0.0);
}

TEST(Aggregation, SymmetricAreaIsAppendedOnBothSides) {
  const PBox input = PBox::fromInterval(2.0, 5.0);
  const PBox total = aggregate({.input = input, .model_form = modelFormOf(0.5), .numerical = 0.25}).total;
  EXPECT_EQ(total.left().min(), 1.25);
  EXPECT_EQ(total.right().max(), 5.75);
}

TEST(Aggregation, HoldsTheInputAndGrowsWithEveryPart) {
  RandomCases cases(95);
  for (int k = 0; k < 100; ++k) {
    const PBox input = cases.box();
    const Margin form{.below = cases.uniform(0, 1), .above = cases.uniform(0, 1)};
    const double numerical = cases.uniform(0, 1);
    const auto box = aggregate({.input = input, .model_form = form, .numerical = numerical});
    EXPECT_NEAR(box.total.area(), input.area() + form.below + form.above + 2.0 * numerical, 1e-12);
    for (int i = 1; i < 20; ++i) {
      const double p = i / 20.0;
      EXPECT_LE(box.total.left().quantile(p), box.with_model_form.left().quantile(p));
      EXPECT_LE(box.with_model_form.left().quantile(p), input.left().quantile(p));
      EXPECT_GE(box.total.right().quantile(p), box.with_model_form.right().quantile(p));
      EXPECT_GE(box.with_model_form.right().quantile(p), input.right().quantile(p));
    }
  }
}

TEST(Aggregation, ExtrapolatedModelFormIsTheUpperBoundForOneMoreSample) {
  const metrics::PredictedError low{.value = 0.1, .confidence = {0.0, 0.2}, .observation = {0.0, 0.25}};
  const metrics::PredictedError high{.value = 0.5, .confidence = {0.25, 0.75}, .observation = {0.0, 1.0}};
  const Margin form = modelFormOf({.d_plus = low, .d_minus = high});
  EXPECT_EQ(form.below, 1.0);
  EXPECT_EQ(form.above, 0.25);
}

TEST(Aggregation, NothingUncertainLeavesTheInputAsItIs) {
  const PBox input = Edf({1.0, 2.0});
  const auto box = aggregate({.input = input, .model_form = {.below = 0.0, .above = 0.0}});
  EXPECT_EQ(box.total.left(), input.left());
  EXPECT_EQ(box.total.right(), input.right());
}

TEST(Aggregation, RefusesNegativeAndUnboundedParts) {
  const PBox input = Edf({1.0, 2.0});
  EXPECT_THROW((void)aggregate({.input = input, .model_form = modelFormOf(-0.1)}), core::InputError);
  EXPECT_THROW((void)aggregate({.input = input, .model_form = modelFormOf(0.1), .numerical = -0.1}), core::InputError);
  const auto without_bounds =
      metrics::predict(metrics_test::overRange({1, 2}, [](double x) { return x; }), {.never_negative = true})
          .at(std::array{1.5});
  const auto form = modelFormOf({.d_plus = without_bounds, .d_minus = without_bounds});
  EXPECT_THROW((void)aggregate({.input = input, .model_form = form}), core::InputError);
}

}  // namespace
