#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <string>

#include "core/error.h"
#include "metrics/area/area_metric.h"
#include "metrics/area/area_range.h"
#include "metrics/area/double_metric.h"
#include "metrics/area/double_validation_metric.h"
#include "metrics/area/largest_area_metric.h"
#include "metrics/area/signed_scatter.h"
#include "metrics/area/white_west_metric.h"
#include "tests/metrics/random_cases.h"

// Laws that hold for every number this room computes, on samples and on boxes with width on both sides.
namespace {

using metrics::Comparison;
using metrics::Edf;
using metrics::PBox;
using metrics::Shift;
using metrics_test::RandomCases;

struct Quantity {
  std::string name;
  double (*of)(const Comparison& boxes);
  bool follows_direction = false;  ///< changes sign when the axis is reversed
};

double between(const Quantity& quantity, const PBox& simulated, const PBox& measured) {
  return quantity.of({.simulated = simulated, .measured = measured});
}

double bothEdges(const Comparison& boxes) {
  const metrics::DoubleMetric metric = metrics::doubleMetric(boxes);
  return metric.left + metric.right;
}

const std::vector<Quantity>& distances() {
  static const std::vector<Quantity> all = {
      {.name = "Area", .of = metrics::areaValidationMetric},
      {.name = "Scatter", .of = [](const Comparison& b) { return doubleValidationMetric(b).scatter; }},
      {.name = "BalancedScatter",
       .of = [](const Comparison& b) { return doubleValidationMetric(b, Shift::Balanced).scatter; }},
      {.name = "WhiteWest", .of = [](const Comparison& b) { return whiteWestPortions(b).area(); }},
      {.name = "DoubleMetric", .of = bothEdges},
      {.name = "LargestArea", .of = [](const Comparison& b) { return largestAreaMetric(b).area; }},
      {.name = "LargestOfRange", .of = [](const Comparison& b) { return areaRange(b).largest; }},
  };
  return all;
}

const std::vector<Quantity>& signedQuantities() {
  static const std::vector<Quantity> all = {
      {.name = "Bias", .of = [](const Comparison& b) { return areaPortions(b).bias(); }, .follows_direction = true},
      {.name = "BalancedBias", .of = metrics::balancedShift, .follows_direction = true},
      {.name = "SignedScatter", .of = [](const Comparison& b) { return signedScatter(b); }},
      {.name = "BalancedSignedScatter", .of = [](const Comparison& b) { return signedScatter(b, Shift::Balanced); }},
  };
  return all;
}

std::vector<Quantity> all() {
  std::vector<Quantity> both = distances();
  both.insert(both.end(), signedQuantities().begin(), signedQuantities().end());
  return both;
}

constexpr auto kName = [](const auto& parameter) { return parameter.param.name; };

/// The distribution of a x + b. Negative a mirrors the steps: what was the height before one is then 1 - height.
Edf scaled(const Edf& edf, double a, double b) {
  std::vector<double> values;
  std::vector<double> levels;
  for (std::size_t i = 0; i < edf.values().size(); ++i) {
    values.push_back(a * edf.values()[i] + b);
    levels.push_back(a > 0.0 ? edf.levels()[i] : 1.0 - (i == 0 ? 0.0 : edf.levels()[i - 1]));
  }
  if (a < 0.0) {
    std::reverse(values.begin(), values.end());
    std::reverse(levels.begin(), levels.end());
  }
  return Edf::fromSteps(values, levels);
}

PBox scaled(const PBox& box, double a, double b) {
  const Edf left = scaled(box.left(), a, b);
  if (box.isSingleDistribution()) return left;
  const Edf right = scaled(box.right(), a, b);
  return a > 0.0 ? PBox::fromEdges(left, right) : PBox::fromEdges(right, left);
}

// ---- On samples: a metric (of shapes, for the scatter). Sums of 60 terms of size 10: 1e-12 is some hundred roundings.

class Distance : public testing::TestWithParam<Quantity> {};

TEST_P(Distance, OfASampleToItselfIsZero) {
  RandomCases cases(150);
  for (int k = 0; k < 200; ++k) {
    const Edf a = cases.edf();
    EXPECT_EQ(between(GetParam(), a, a), 0.0);
  }
}

TEST_P(Distance, OfSamplesIsSymmetric) {
  RandomCases cases(151);
  for (int k = 0; k < 200; ++k) {
    const Edf a = cases.edf();
    const Edf b = cases.edf();
    EXPECT_NEAR(between(GetParam(), a, b), between(GetParam(), b, a), 1e-12);
  }
}

TEST_P(Distance, OfSamplesKeepsTheTriangleInequality) {
  RandomCases cases(152);
  for (int k = 0; k < 500; ++k) {
    const Edf a = cases.edf();
    const Edf b = cases.edf();
    const Edf c = cases.edf();
    EXPECT_LE(between(GetParam(), a, c), between(GetParam(), a, b) + between(GetParam(), b, c) + 1e-12);
  }
}

TEST_P(Distance, IsNeverNegative) {
  RandomCases cases(153);
  for (int k = 0; k < 300; ++k) EXPECT_GE(between(GetParam(), cases.box(), cases.box()), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Axioms, Distance, testing::ValuesIn(distances()), kName);

TEST(AreaMetric, OfDifferentSamplesIsNotZero) {
  RandomCases cases(154);
  for (int k = 0; k < 300; ++k) {
    const Edf a = cases.edf();
    const Edf b = cases.edf();
    EXPECT_EQ(between(distances().front(), a, b) == 0.0, a == b);
  }
}

// {0} and {10} differ by 10, yet a box between them differs from neither.
TEST(AreaMetric, OfBoxesIsNoMetric) {
  const PBox box = PBox::fromInterval(0.0, 10.0);
  EXPECT_EQ(between(distances().front(), Edf({0.0}), box), 0.0);
  EXPECT_EQ(between(distances().front(), box, Edf({10.0})), 0.0);
  EXPECT_EQ(between(distances().front(), Edf({0.0}), Edf({10.0})), 10.0);
}

class Signed : public testing::TestWithParam<Quantity> {};

// From a to c is from a to b and on to c; so there is no way but back from b to a.
TEST_P(Signed, OfSamplesAddsUpOnTheWay) {
  RandomCases cases(155);
  for (int k = 0; k < 500; ++k) {
    const Edf a = cases.edf();
    const Edf b = cases.edf();
    const Edf c = cases.edf();
    EXPECT_NEAR(between(GetParam(), a, c), between(GetParam(), a, b) + between(GetParam(), b, c), 1e-12);
    EXPECT_NEAR(between(GetParam(), a, b), -between(GetParam(), b, a), 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Axioms, Signed, testing::ValuesIn(signedQuantities()), kName);

// ---- On boxes, either side with or without width.

class Any : public testing::TestWithParam<Quantity> {};

// Units: d(a X + b, a Y + b) = |a| d(X, Y); a bias follows the direction of the axis, a width does not.
TEST_P(Any, ScalesWithTheUnitAndIgnoresACommonOffset) {
  RandomCases cases(156);
  for (int k = 0; k < 300; ++k) {
    const PBox simulated = cases.box(k % 3 == 0 ? 1 : 4);
    const PBox measured = cases.box(k % 2 == 0 ? 1 : 4);
    const double b = cases.uniform(-20.0, 20.0);
    for (const double a : {1.0, 100.0, 0.3, -1.0, -2.5}) {
      const double factor = GetParam().follows_direction ? a : std::abs(a);
      EXPECT_NEAR(between(GetParam(), scaled(simulated, a, b), scaled(measured, a, b)),
                  factor * between(GetParam(), simulated, measured), 1e-11 * (1.0 + std::abs(a)));
    }
  }
}

TEST_P(Any, IsIndependentOfTheOrderOfValuesAndRuns) {
  RandomCases cases(157);
  for (int k = 0; k < 100; ++k) {
    std::vector<std::vector<double>> runs{cases.sample(), cases.sample(), cases.sample()};
    std::vector<double> real = cases.sample();
    const auto box = [](const std::vector<std::vector<double>>& samples) {
      return PBox::envelope(std::vector<Edf>(samples.begin(), samples.end()));
    };
    const double forth = between(GetParam(), box(runs), Edf(real));
    for (std::vector<double>& run : runs) std::reverse(run.begin(), run.end());
    std::rotate(runs.begin(), runs.begin() + 1, runs.end());
    std::reverse(real.begin(), real.end());
    EXPECT_EQ(between(GetParam(), box(runs), Edf(real)), forth);
  }
}

TEST_P(Any, TakesWholeWeightsAsRepetitions) {
  RandomCases cases(158);
  for (int k = 0; k < 100; ++k) {
    const std::vector<double> values = cases.sample();
    std::vector<double> weights;
    std::vector<double> repeated;
    for (const double x : values) {
      weights.push_back(1.0 + std::floor(cases.uniform(0.0, 4.0)));
      repeated.insert(repeated.end(), static_cast<std::size_t>(weights.back()), x);
    }
    const PBox measured = cases.box(3);
    EXPECT_EQ(between(GetParam(), Edf::weighted(values, weights), measured),
              between(GetParam(), Edf(repeated), measured));
  }
}

// A sample that is repeated as a whole is the same distribution.
TEST_P(Any, DoesNotDependOnTheSampleSizeItself) {
  RandomCases cases(159);
  for (int k = 0; k < 100; ++k) {
    const std::vector<double> values = cases.sample();
    std::vector<double> thrice;
    for (int i = 0; i < 3; ++i) thrice.insert(thrice.end(), values.begin(), values.end());
    const PBox measured = cases.box(3);
    EXPECT_NEAR(between(GetParam(), Edf(thrice), measured), between(GetParam(), Edf(values), measured), 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Axioms, Any, testing::ValuesIn(all()), kName);

// ---- One value, and values that are none.

TEST(AreaMetrics, OfOneValueEachAreTheirDifferenceAndNoScatter) {
  const PBox simulated = Edf({7.0});
  const PBox measured = Edf({4.5});
  const Comparison boxes{.simulated = simulated, .measured = measured};
  EXPECT_EQ(areaValidationMetric(boxes), 2.5);
  EXPECT_EQ(areaPortions(boxes).bias(), 2.5);
  EXPECT_EQ(doubleValidationMetric(boxes).scatter, 0.0);
  EXPECT_EQ(signedScatter(boxes), 0.0);
  EXPECT_EQ(areaRange(boxes).largest, 2.5);
}

TEST(AreaMetrics, GetNoSampleThatIsEmptyOrNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> values(1000, 1.0);
  EXPECT_THAT([] { (void)PBox(Edf(std::vector<double>{})); },
              testing::ThrowsMessage<core::InputError>(testing::HasSubstr("has no values")));
  for (const double bad : {nan, std::numeric_limits<double>::infinity()}) {
    values[776] = bad;
    EXPECT_THAT([&] { (void)PBox(Edf(values)); },
                testing::ThrowsMessage<core::InputError>(testing::HasSubstr("value 777: is")));
  }
}

}  // namespace
