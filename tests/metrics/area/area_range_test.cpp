#include "metrics/area/area_range.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "metrics/area/area_metric.h"
#include "metrics/area/largest_area_metric.h"
#include "metrics/distributions/level_walk.h"
#include "tests/metrics/random_cases.h"

namespace {

using metrics::AreaRange;
using metrics::areaRange;
using metrics::areaValidationMetric;
using metrics::CommonLevel;
using metrics::eachCommonLevel;
using metrics::Edf;
using metrics::PBox;
using metrics_test::RandomCases;
using metrics_test::widened;

AreaRange range(const PBox& simulated, const PBox& measured, std::size_t limit = 50'000'000) {
  return areaRange({.simulated = simulated, .measured = measured}, limit);
}

/// Tries every pair of rising choices on levels cut in halves, from edge values and values between them: exponential,
/// without dynamic programming, free to step within a level.
struct Exhaustive {
  std::vector<CommonLevel<4>> levels;
  std::vector<double> simulated;
  std::vector<double> measured;
  double smallest = std::numeric_limits<double>::infinity();
  double largest = -smallest;

  Exhaustive(const PBox& sim, const PBox& real) {
    eachCommonLevel<4>({&sim.left(), &sim.right(), &real.left(), &real.right()}, [&](const CommonLevel<4>& at) {
      const double middle = 0.5 * (at.below + at.level);
      levels.push_back({.below = at.below, .level = middle, .quantiles = at.quantiles});
      levels.push_back({.below = middle, .level = at.level, .quantiles = at.quantiles});
      for (const int k : {0, 1}) simulated.push_back(at.quantiles[k]);
      for (const int k : {2, 3}) measured.push_back(at.quantiles[k]);
    });
    makeChoices(simulated);
    makeChoices(measured);
    tryFrom(0, 0, 0, 0.0);
  }

 private:
  // The best distance may be reached at an edge of the other box or between two values.
  static void makeChoices(std::vector<double>& values) {
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    values.push_back(0.3 * values[0] + 0.7 * values[n - 1]);
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
  }

  void tryFrom(std::size_t level, std::size_t i_from, std::size_t j_from, double sum) {
    if (level == levels.size()) {
      smallest = std::min(smallest, sum);
      largest = std::max(largest, sum);
      return;
    }
    const auto& [sim_low, sim_high, real_low, real_high] = levels[level].quantiles;
    for (std::size_t i = i_from; i < simulated.size() && simulated[i] <= sim_high; ++i) {
      if (simulated[i] < sim_low) continue;
      for (std::size_t j = j_from; j < measured.size() && measured[j] <= real_high; ++j) {
        if (measured[j] < real_low) continue;
        tryFrom(level + 1, i, j, sum + levels[level].width() * std::abs(simulated[i] - measured[j]));
      }
    }
  }
};

// Two runs of two values each make boxes that overlap, cross and cover each other.
TEST(AreaRange, HasTheLargestOfAllChoices) {
  RandomCases cases(140);
  int uneven = 0;
  for (int k = 0; k < 400; ++k) {
    const PBox simulated = cases.box(2, 2);
    const PBox measured = cases.box(2, 2);
    const AreaRange result = range(simulated, measured);
    const Exhaustive all(simulated, measured);
    EXPECT_NEAR(result.largest, all.largest, 1e-12);
    EXPECT_LE(result.smallest, all.smallest + 1e-12);
    EXPECT_EQ(result.error, 0.0);
    uneven += simulated.left().levels().size() > 1 && measured.left().levels().size() > 1 ? 1 : 0;
  }
  EXPECT_GT(uneven, 50);
}

// The pair named in the header: min(m, R) of both boxes with m = max(L_sim, L_real).
TEST(AreaRange, HasTheAreaMetricAsItsSmallestAndReachesIt) {
  RandomCases cases(141);
  for (int k = 0; k < 500; ++k) {
    const PBox simulated = cases.box();
    const PBox measured = cases.box();
    metrics::EdfBuilder nearest_simulated;
    metrics::EdfBuilder nearest_measured;
    eachCommonLevel<4>({&simulated.left(), &simulated.right(), &measured.left(), &measured.right()},
                       [&](const CommonLevel<4>& at) {
                         const double m = std::max(at.quantiles[0], at.quantiles[2]);
                         nearest_simulated.step(std::min(m, at.quantiles[1]), at.level);
                         nearest_measured.step(std::min(m, at.quantiles[3]), at.level);
                       });
    const double reached = areaValidationMetric(
        {.simulated = std::move(nearest_simulated).build(), .measured = std::move(nearest_measured).build()});
    EXPECT_NEAR(range(simulated, measured).smallest, reached, 1e-12);
  }
}

TEST(AreaRange, OfIntervalsReachesFromTheNearestToTheFarthestEnds) {
  const AreaRange apart = range(PBox::fromInterval(2.0, 5.0), PBox::fromInterval(6.0, 9.0));
  EXPECT_EQ(apart.smallest, 1.0);
  EXPECT_EQ(apart.largest, 7.0);
  const AreaRange inside = range(PBox::fromInterval(0.0, 10.0), PBox::fromInterval(4.0, 5.0));
  EXPECT_EQ(inside.smallest, 0.0);
  EXPECT_EQ(inside.largest, 6.0);
}

// S = F + c +- w against F +- v.
TEST(AreaRange, OfWidenedCopiesIsTheShiftAndBothWidths) {
  RandomCases cases(142);
  for (int k = 0; k < 200; ++k) {
    const Edf edf = cases.edf();
    const double c = cases.uniform(-2.0, 2.0);
    const double w = cases.uniform(0.0, 2.0);
    const double v = cases.uniform(0.0, 2.0);
    const AreaRange result = range(widened(edf.shifted(c), w), widened(edf, v));
    EXPECT_NEAR(result.smallest, std::max(0.0, std::abs(c) - w - v), 1e-12);
    EXPECT_NEAR(result.largest, std::abs(c) + w + v, 1e-12);
  }
}

TEST(AreaRange, OfSamplesIsTheirDistanceAlone) {
  const AreaRange result = range(Edf({1.0, 2.0}), Edf({0.0, 5.0}));
  EXPECT_EQ(result.smallest, result.largest);
  EXPECT_EQ(result.smallest, 2.0);
}

TEST(AreaRange, AgainstASampleIsThatOfTheLargestAreaMetricFromEitherSide) {
  RandomCases cases(143);
  for (int k = 0; k < 200; ++k) {
    const PBox box = cases.box();
    const PBox sample = cases.edf();
    const double expected = metrics::largestAreaMetric({.simulated = box, .measured = sample}).area;
    EXPECT_EQ(range(box, sample).largest, expected);
    EXPECT_EQ(range(sample, box).largest, expected);
  }
}

TEST(AreaRange, HoldsEveryPairOfRuns) {
  RandomCases cases(144);
  for (int k = 0; k < 200; ++k) {
    const std::vector<Edf> simulated = cases.runs();
    const std::vector<Edf> measured = cases.runs();
    const AreaRange result = range(PBox::envelope(simulated), PBox::envelope(measured));
    for (const Edf& s : simulated) {
      for (const Edf& m : measured) {
        const double area = areaValidationMetric({.simulated = s, .measured = m});
        EXPECT_GE(area, result.smallest - 1e-12);
        EXPECT_LE(area, result.largest + 1e-12);
      }
    }
  }
}

TEST(AreaRange, OfExchangedSidesIsTheSame) {
  RandomCases cases(145);
  for (int k = 0; k < 100; ++k) {
    const PBox a = cases.box();
    const PBox b = cases.box();
    EXPECT_NEAR(range(a, b).smallest, range(b, a).smallest, 1e-12);
    EXPECT_NEAR(range(a, b).largest, range(b, a).largest, 1e-12);
  }
}

TEST(AreaRange, CoarseSearchStaysWithinTheErrorThatItReports) {
  RandomCases cases(146);
  int coarse = 0;
  for (int k = 0; k < 100; ++k) {
    const PBox simulated = cases.box(4, 60);
    const PBox measured = cases.box(4, 60);
    const AreaRange exact = range(simulated, measured);
    const AreaRange quick = range(simulated, measured, 1000);
    EXPECT_EQ(exact.error, 0.0);
    EXPECT_NEAR(quick.largest, exact.largest, quick.error + 1e-12);
    coarse += quick.error > 0.0 ? 1 : 0;
  }
  EXPECT_GT(coarse, 20);
}

}  // namespace
