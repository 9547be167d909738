#include "metrics/resampling/sorted_units.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>

#include "core/error.h"
#include "tests/metrics/random_cases.h"
#include "tests/support/thrown_message.h"

namespace {

using metrics::Counts;
using metrics::Edf;
using metrics::SortedUnits;
using metrics_test::RandomCases;

core::Random randomOf(std::uint32_t replicate) { return core::Random({.seed = 5, .sample = replicate}); }

TEST(RepeatedEdf, IsTheEdfOfTheRepeatedValues) {
  RandomCases cases(60);
  for (int k = 0; k < 300; ++k) {
    const Edf edf = cases.edf();
    Counts counts;
    std::vector<double> values;
    for (const double x : edf.values()) {
      counts.push_back(static_cast<std::uint32_t>(cases.uniform(0.0, 4.0)));
      values.insert(values.end(), counts.back(), x);
    }
    if (values.empty()) continue;
    const Edf repeated = Edf::repeated(edf.values(), counts);
    EXPECT_EQ(repeated, Edf(values));
    EXPECT_EQ(repeated.n(), values.size());
    EXPECT_EQ(repeated.effectiveN(), static_cast<double>(values.size()));
  }
}

TEST(RepeatedEdf, OfNothingIsRefused) {
  EXPECT_THROW((void)Edf::repeated(std::vector{1.0, 2.0}, Counts{0, 0}), core::InputError);
  EXPECT_THROW((void)Edf::repeated(std::vector{1.0, 2.0}, Counts{1}), core::InputError);
}

TEST(SortedUnits, TakenOnceAreTheSample) {
  RandomCases cases(61);
  for (int k = 0; k < 200; ++k) {
    const std::vector<double> values = cases.sample();
    std::vector<std::uint32_t> units;
    for (std::size_t i = 0; i < values.size(); ++i) units.push_back(static_cast<std::uint32_t>(cases.uniform(0, 5)));
    for (const auto& sample :
         {metrics::UnitSample{.values = values, .units = units}, metrics::UnitSample{.values = values, .units = {}}}) {
      const SortedUnits sorted(sample, "sample");
      Counts steps;
      sorted.countSteps(Counts(sorted.unitCount(), 1), steps);
      EXPECT_EQ(Edf::repeated(sorted.steps(), steps), Edf(values));
    }
  }
}

TEST(SortedUnits, BringAllTheirValuesAndNoOthers) {
  const std::vector<double> values{3.0, 1.0, 2.0, 1.0, 5.0};
  const std::vector<std::uint32_t> units{7, 2, 7, 7, 4};
  const SortedUnits sorted({.values = values, .units = units}, "sample");
  EXPECT_TRUE(std::ranges::equal(sorted.units(), Counts{2, 4, 7}));
  EXPECT_TRUE(std::ranges::equal(sorted.steps(), std::vector{1.0, 2.0, 3.0, 5.0}));
  Counts steps;
  sorted.countSteps(Counts{0, 1, 2}, steps);
  EXPECT_EQ(steps, (Counts{2, 2, 2, 1}));
}

TEST(SortedUnits, SayWhichValueIsWrong) {
  const auto messageFor = [](std::vector<double> values, Counts units) {
    return test_support::thrownMessage([&] { SortedUnits({.values = values, .units = units}, "simulated run 2"); });
  };
  EXPECT_NE(messageFor({}, {}).find("simulated run 2"), std::string::npos);
  EXPECT_NE(messageFor({1.0, std::numeric_limits<double>::quiet_NaN()}, {}).find("run 2, value 2"), std::string::npos);
  EXPECT_NE(messageFor({1.0, 2.0}, {1}).find("2 values have 1 units"), std::string::npos);
}

TEST(DrawWithReplacement, TakesAsManyUnitsAsThereAre) {
  for (const std::size_t block : {1, 2, 3, 7}) {
    for (std::uint32_t replicate = 0; replicate < 50; ++replicate) {
      core::Random random = randomOf(replicate);
      Counts counts;
      metrics::drawWithReplacement(20, 20, block, random, counts);
      EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), 0u), 20u);
    }
  }
}

// Counts of N draws: mean 1, variance 1 - 1/N, nearly Poisson with kurtosis 4. Over R N counts the variance scatters by
// sqrt(3 / (R N)) = 0.006, over R counts the mean of one unit by 1/sqrt(R).
TEST(DrawWithReplacement, GivesMultinomialCounts) {
  const std::size_t units = 50;
  const std::uint32_t replicates = 2000;
  double squares = 0.0;
  std::vector<double> of_unit(units, 0.0);
  for (std::uint32_t replicate = 0; replicate < replicates; ++replicate) {
    core::Random random = randomOf(replicate);
    Counts counts;
    metrics::drawWithReplacement(units, units, 1, random, counts);
    for (std::size_t u = 0; u < units; ++u) {
      squares += (counts[u] - 1.0) * (counts[u] - 1.0);
      of_unit[u] += counts[u];
    }
  }
  EXPECT_NEAR(squares / (units * replicates), 1.0 - 1.0 / units, 0.03);
  for (const double sum : of_unit) EXPECT_NEAR(sum / replicates, 1.0, 5.0 / std::sqrt(replicates));
}

// With N = 2 b two blocks are drawn, each covering b neighbours: counts rise and fall in steps at their ends only.
TEST(DrawWithReplacement, KeepsNeighboursOfABlockTogether) {
  for (std::uint32_t replicate = 0; replicate < 200; ++replicate) {
    core::Random random = randomOf(replicate);
    Counts counts;
    metrics::drawWithReplacement(40, 40, 20, random, counts);
    int changes = counts.front() > 0 ? 1 : 0;
    for (std::size_t u = 1; u < counts.size(); ++u) changes += counts[u] != counts[u - 1] ? 1 : 0;
    changes += counts.back() > 0 ? 1 : 0;
    EXPECT_LE(changes, 4);
    EXPECT_LE(*std::max_element(counts.begin(), counts.end()), 2u);
  }
}

}  // namespace
