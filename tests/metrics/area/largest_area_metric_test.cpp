#include "metrics/area/largest_area_metric.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "metrics/area/area_metric.h"
#include "metrics/distributions/level_walk.h"
#include "tests/metrics/random_cases.h"

namespace {

using metrics::areaValidationMetric;
using metrics::CommonLevel;
using metrics::eachCommonLevel;
using metrics::Edf;
using metrics::LargestArea;
using metrics::largestAreaMetric;
using metrics::PBox;
using metrics_test::RandomCases;
using metrics_test::widened;

LargestArea largest(const PBox& simulated, const PBox& measured, std::size_t limit = 50'000'000) {
  return largestAreaMetric({.simulated = simulated, .measured = measured}, limit);
}

/// Tries every rising choice of quantiles from a fine set of values, edges included, on levels cut in halves:
/// exponential, without dynamic programming, not restricted to edge values, free to step within a level.
struct Exhaustive {
  std::vector<CommonLevel<4>> levels;
  std::vector<double> values;

  Exhaustive(const PBox& simulated, const PBox& measured) {
    eachCommonLevel<4>({&simulated.left(), &simulated.right(), &measured.left(), &measured.right()},
                       [&](const CommonLevel<4>& at) {
                         const double middle = 0.5 * (at.below + at.level);
                         levels.push_back({.below = at.below, .level = middle, .quantiles = at.quantiles});
                         levels.push_back({.below = middle, .level = at.level, .quantiles = at.quantiles});
                         const auto& [low, high, real_low, real_high] = at.quantiles;
                         values.insert(values.end(), {low, high, 0.5 * (low + high)});
                       });
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
  }

  [[nodiscard]] double best(std::size_t level = 0, std::size_t from = 0) const {
    if (level == levels.size()) return 0.0;
    const auto& [low, high, real_low, real_high] = levels[level].quantiles;
    double most = -std::numeric_limits<double>::infinity();
    for (std::size_t i = from; i < values.size() && values[i] <= high; ++i) {
      if (values[i] < low) continue;
      const double cost = std::max({0.0, real_low - values[i], values[i] - real_high});
      most = std::max(most, levels[level].width() * cost + best(level + 1, i));
    }
    return most;
  }
};

TEST(LargestAreaMetric, IsTheBestOfAllChoices) {
  RandomCases cases(60);
  for (int k = 0; k < 300; ++k) {
    const PBox simulated = cases.box(3, 3);
    const PBox measured = cases.box(k % 2 == 0 ? 1 : 2, 2);
    const LargestArea result = largest(simulated, measured);
    EXPECT_NEAR(result.area, Exhaustive(simulated, measured).best(), 1e-12);
    EXPECT_EQ(result.error, 0.0);
  }
}

TEST(LargestAreaMetric, OfASingleDistributionIsTheArea) {
  const PBox simulated = Edf({1.0, 2.0});
  const PBox measured = Edf({0.0, 5.0});
  EXPECT_EQ(largest(simulated, measured).area, areaValidationMetric({.simulated = simulated, .measured = measured}));
}

TEST(LargestAreaMetric, OfANumberAndAnIntervalIsTheFarEnd) {
  EXPECT_EQ(largest(PBox::fromInterval(2.0, 5.0), Edf({7.0})).area, 5.0);
}

TEST(LargestAreaMetric, OfAShiftedAndWidenedCopyIsTheirSum) {
  RandomCases cases(61);
  for (int k = 0; k < 200; ++k) {
    const Edf measured = cases.edf();
    const double c = cases.uniform(-2.0, 2.0);
    const double w = cases.uniform(0.0, 2.0);
    EXPECT_NEAR(largest(widened(measured.shifted(c), w), measured).area, std::abs(c) + w, 1e-12);
  }
}

// For S = EDF +- w no choice gains more than w over the nearest; all of it only if quantile differences rise.
TEST(LargestAreaMetric, ExceedsTheAreaOfTheCentreByAtMostTheHalfWidth) {
  RandomCases cases(62);
  for (int k = 0; k < 200; ++k) {
    const Edf centre = cases.edf();
    const Edf measured = cases.edf();
    const double area = areaValidationMetric({.simulated = centre, .measured = measured});
    const double result = largest(widened(centre, 0.3), measured).area;
    EXPECT_LE(result, area + 0.3 + 1e-12);
    EXPECT_GE(result, area - 1e-12);
  }
  const Edf narrow({-1.0, 0.0, 1.0});
  const Edf wide({-2.0, 0.0, 2.0});
  const double area = 2.0 / 3.0;
  EXPECT_NEAR(largest(widened(wide, 0.3), narrow).area, area + 0.3, 1e-12);
  // Narrower, and the stretches overlap: the first value high (0.5, cost 2.5) leaves the last no lower (cost 1.5).
  EXPECT_NEAR(largest(widened(narrow, 1.5), wide).area, (2.5 + 0.5 + 1.5) / 3.0, 1e-12);
}

TEST(LargestAreaMetric, IsNoSmallerThanTheAreaOfAnyRun) {
  RandomCases cases(63);
  for (int k = 0; k < 200; ++k) {
    const std::vector<Edf> runs = cases.runs();
    const Edf measured = cases.edf();
    const double result = largest(PBox::envelope(runs), measured).area;
    for (const Edf& run : runs) {
      EXPECT_GE(result, areaValidationMetric({.simulated = run, .measured = measured}) - 1e-12);
    }
  }
}

TEST(LargestAreaMetric, CoarseSearchStaysWithinTheErrorThatItReports) {
  RandomCases cases(64);
  int coarse = 0;
  for (int k = 0; k < 100; ++k) {
    const PBox simulated = cases.box(4, 200);
    const PBox measured = cases.edf(200);
    const LargestArea exact = largest(simulated, measured);
    const LargestArea quick = largest(simulated, measured, 500);
    EXPECT_NEAR(quick.area, exact.area, quick.error + 1e-12);
    coarse += quick.error > 0.0 ? 1 : 0;
  }
  EXPECT_GT(coarse, 20);
}

}  // namespace
