#include "metrics/area/area_over_values.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>

#include "metrics/samples/wasserstein.h"
#include "tests/metrics/random_cases.h"

namespace {

using metrics::AreaPortions;
using metrics::areaPortions;
using metrics::areaPortionsOverValues;
using metrics::Comparison;
using metrics::Edf;
using metrics::PBox;
using metrics_test::RandomCases;

void expectEqual(const Comparison& boxes, double tolerance) {
  const AreaPortions over_levels = areaPortions(boxes);
  const AreaPortions over_values = areaPortionsOverValues(boxes);
  EXPECT_NEAR(over_levels.d_plus, over_values.d_plus, tolerance);
  EXPECT_NEAR(over_levels.d_minus, over_values.d_minus, tolerance);
}

// Up to 150 steps of size 10: 1e-12 is some hundred roundings.
TEST(AreaOverValues, EqualsTheAreaOverProbability) {
  RandomCases cases(120);
  for (int k = 0; k < 2000; ++k) {
    const PBox simulated = cases.box();
    const PBox measured = cases.box(k % 2 == 0 ? 1 : 5);
    expectEqual({.simulated = simulated, .measured = measured}, 1e-12);
  }
}

TEST(AreaOverValues, EqualsTheAreaOverProbabilityOfWeightedSamples) {
  RandomCases cases(121);
  const auto weighted = [&cases] {
    const std::vector<double> values = cases.sample();
    std::vector<double> weights;
    for (std::size_t i = 0; i < values.size(); ++i) weights.push_back(cases.uniform(0.0, 2.0));
    return Edf::weighted(values, weights);
  };
  for (int k = 0; k < 500; ++k) {
    const PBox simulated = weighted();
    const PBox measured = weighted();
    expectEqual({.simulated = simulated, .measured = measured}, 1e-12);
  }
}

TEST(AreaOverValues, OfTwoSamplesIsTheirWassersteinDistance) {
  RandomCases cases(122);
  for (int k = 0; k < 200; ++k) {
    const Edf simulated = cases.edf();
    const Edf measured = cases.edf();
    EXPECT_NEAR(areaPortionsOverValues({.simulated = simulated, .measured = measured}).area(),
                metrics::wassersteinDistance({.simulated = simulated, .measured = measured}), 1e-12);
  }
}

// 10^7 values, the midpoints of (0, 1) in scattered order (7368787 has no factor 2 or 5: each is met once), against
// its double. Quantiles p and 2 p: area 1/2, all of it above; against its middle: mean |x - 1/2| = 1/4.
TEST(AreaOverValues, OfTenMillionValuesIsTheClosedFormInBothDomains) {
  constexpr std::size_t kValues = 10'000'000;
  const auto grid = [](double width) {
    std::vector<double> values(kValues);
    for (std::size_t i = 0; i < kValues; ++i) {
      values[i] = width * (static_cast<double>(i * 7'368'787 % kValues) + 0.5) / static_cast<double>(kValues);
    }
    return Edf(std::move(values));
  };
  const PBox simulated = grid(2.0);
  const PBox measured = grid(1.0);
  const PBox middle = Edf({0.5});
  ASSERT_EQ(measured.left().values().size(), kValues);
  for (const auto portions : {areaPortions, areaPortionsOverValues}) {
    const AreaPortions apart = portions({.simulated = simulated, .measured = measured});
    EXPECT_NEAR(apart.d_minus, 0.5, 1e-13);
    EXPECT_EQ(apart.d_plus, 0.0);
    EXPECT_NEAR(portions({.simulated = measured, .measured = middle}).area(), 0.25, 1e-13);
  }
}

}  // namespace
