#include "metrics/distributions/edf.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>

#include "core/error.h"
#include "core/parallel.h"
#include "metrics/distributions/level_walk.h"
#include "tests/metrics/random_cases.h"

namespace {

using metrics::Edf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(Edf, StepsByOneOverNAtEachValue) {
  const Edf edf({3.0, 1.0, 2.0, 2.0});
  EXPECT_THAT(edf.values(), ElementsAre(1.0, 2.0, 3.0));
  EXPECT_THAT(edf.levels(), ElementsAre(0.25, 0.75, 1.0));
  EXPECT_EQ(edf.n(), 4U);
}

TEST(Edf, MinusZeroAndZeroAreOneValue) { EXPECT_THAT(Edf({0.0, -0.0}).values(), ElementsAre(0.0)); }

// At the head, in the middle and among ties: each takes another way through the constructor.
TEST(Edf, MinusZeroOfASampleThatAscendsBecomesZero) {
  const std::vector<std::vector<double>> samples{{-0.0, 1.0}, {-1.0, -0.0, 1.0}, {-0.0, 0.0, 1.0}, {-0.0}};
  for (const auto& sample : samples) {
    const Edf edf(sample);
    for (const double x : edf.values()) EXPECT_FALSE(x == 0.0 && std::signbit(x));
  }
}

TEST(Edf, OrderOfASampleDoesNotMatter) {
  metrics_test::RandomCases cases(6);
  for (int k = 0; k < 200; ++k) {
    std::vector<double> sample = cases.sample(500);
    const Edf edf(sample);
    std::sort(sample.begin(), sample.end());
    EXPECT_EQ(Edf(sample), edf);
    std::reverse(sample.begin(), sample.end());
    EXPECT_EQ(Edf(sample), edf);
  }
}

TEST(Edf, StepsAreEqualExactlyIfNoTwoValuesAre) {
  EXPECT_TRUE(Edf({3.0, 1.0, 2.0}).hasEqualSteps());
  EXPECT_FALSE(Edf({3.0, 1.0, 1.0}).hasEqualSteps());
  EXPECT_TRUE(Edf({4.0}).hasEqualSteps());
  const Edf apart({1.0, 1.0 + 1e-15, 2.0});
  EXPECT_FALSE(apart.shifted(1e6).hasEqualSteps());  // rounding has tied two
  EXPECT_THAT(apart.shifted(1e6).levels(), ElementsAre(2.0 / 3.0, 1.0));
}

// The same two ways to a level, and the search for one, with steps of equal height (levels are computed) and without
// (levels are stored).
TEST(Edf, LevelsAreTheCorrectlyRoundedFractions) {
  for (const int n : {1, 2, 3, 10, 49, 1000, 70001}) {
    std::vector<double> values(static_cast<std::size_t>(n));
    std::iota(values.begin(), values.end(), 0.0);
    const Edf edf(values);
    for (std::size_t i = 0; i < edf.values().size(); ++i) {
      const double level = static_cast<double>(i + 1) / n;
      ASSERT_EQ(edf.levels()[i], level);
      ASSERT_EQ(edf.level(i), level);
      ASSERT_EQ(edf.quantile(level), edf.values()[i]);
      ASSERT_EQ(edf.quantile(std::nextafter(level, 2.0)), edf.values()[std::min(i + 1, edf.values().size() - 1)]);
    }
  }
}

TEST(Edf, QuantilesBeyondTheEndsAreTheEnds) {
  for (const Edf& edf : {Edf({1.0, 2.0, 3.0}), Edf({1.0, 2.0, 2.0, 3.0})}) {
    EXPECT_EQ(edf.quantile(-1.0), 1.0);
    EXPECT_EQ(edf.quantile(0.0), 1.0);
    EXPECT_EQ(edf.quantile(1.0), 3.0);
    EXPECT_EQ(edf.quantile(2.0), 3.0);
  }
}

// Copies share steps whose levels are written down on first use: by one thread only.
TEST(Edf, ManyThreadsMayAskACopyForItsLevels) {
  std::vector<double> values(10'000);
  std::iota(values.begin(), values.end(), 0.0);
  const Edf edf(values);
  std::vector<double> sums(64);
  core::parallelFor(sums.size(), 1, [&](std::size_t begin, std::size_t) {
    const Edf copy = edf;
    for (const double level : copy.levels()) sums[begin] += level;
  });
  for (const double sum : sums) EXPECT_EQ(sum, sums.front());
  EXPECT_NEAR(sums.front(), 5000.5, 1e-8);
}

TEST(Edf, CdfIsTheShareOfValuesNotAbove) {
  const Edf edf({1.0, 2.0, 2.0, 3.0});
  EXPECT_EQ(edf.cdf(0.9), 0.0);
  EXPECT_EQ(edf.cdf(1.0), 0.25);
  EXPECT_EQ(edf.cdf(2.5), 0.75);
  EXPECT_EQ(edf.cdf(3.0), 1.0);
}

// Galois: quantile(p) <= x exactly if p <= cdf(x).
TEST(Edf, QuantileIsTheLeftContinuousInverse) {
  metrics_test::RandomCases cases(1);
  for (int k = 0; k < 200; ++k) {
    const Edf edf = cases.edf();
    for (int i = 0; i < 20; ++i) {
      const double p = cases.uniform(1e-9, 1.0);
      const double x = cases.uniform(-6.0, 6.0);
      EXPECT_EQ(edf.quantile(p) <= x, p <= edf.cdf(x));
    }
    for (std::size_t i = 0; i < edf.levels().size(); ++i) EXPECT_EQ(edf.quantile(edf.levels()[i]), edf.values()[i]);
  }
  EXPECT_EQ(Edf({1.0, 2.0}).quantile(0.0), 1.0);
}

TEST(Edf, MomentsOfASmallSampleAreThoseOfTheTextbook) {
  const Edf edf({2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0});
  EXPECT_DOUBLE_EQ(edf.mean(), 5.0);
  EXPECT_DOUBLE_EQ(edf.median(), 4.5);
  EXPECT_DOUBLE_EQ(edf.standardDeviation(), std::sqrt(32.0 / 7.0));
}

TEST(Edf, MedianOfAnOddSampleIsItsMiddleValue) { EXPECT_EQ(Edf({9.0, 1.0, 4.0}).median(), 4.0); }

// 1e6 apart, 1e-3 wide: a sum of squares would have no digit left.
TEST(Edf, SmallSpreadFarFromZeroKeepsItsDigits) {
  const Edf edf({1e6 + 0.001, 1e6 + 0.002, 1e6 + 0.003});
  EXPECT_NEAR(edf.mean() - 1e6, 0.002, 1e-9);
  EXPECT_NEAR(edf.standardDeviation(), 0.001, 1e-9);
}

TEST(Edf, OneValueHasNoStandardDeviation) {
  EXPECT_TRUE(std::isnan(Edf({4.0}).standardDeviation()));
  EXPECT_EQ(Edf({4.0}).mean(), 4.0);
  EXPECT_EQ(Edf({4.0}).median(), 4.0);
}

TEST(Edf, WholeWeightsAreRepetitions) {
  metrics_test::RandomCases cases(2);
  for (int k = 0; k < 100; ++k) {
    const std::vector<double> values = cases.sample();
    std::vector<double> weights;
    std::vector<double> repeated;
    for (const double x : values) {
      weights.push_back(std::floor(cases.uniform(0.0, 4.0)));
      repeated.insert(repeated.end(), static_cast<std::size_t>(weights.back()), x);
    }
    if (repeated.empty()) continue;
    EXPECT_EQ(Edf::weighted(values, weights), Edf(repeated));
  }
}

TEST(Edf, EqualWeightsOfAnySizeAreNoWeights) {
  const std::vector<double> values{3.0, 1.0, 4.0, 1.0, 5.0};
  const Edf edf = Edf::weighted(values, std::vector<double>(5, 0.25));
  EXPECT_EQ(edf, Edf(values));
  EXPECT_EQ(edf.n(), 5U);
  EXPECT_DOUBLE_EQ(edf.effectiveN(), 5.0);
  EXPECT_DOUBLE_EQ(edf.standardDeviation(), Edf(values).standardDeviation());
}

TEST(Edf, ValuesOfWeightZeroAreDropped) {
  const Edf edf = Edf::weighted(std::vector{1.0, 2.0, 3.0}, std::vector{1.0, 0.0, 1.0});
  EXPECT_THAT(edf.values(), ElementsAre(1.0, 3.0));
  EXPECT_EQ(edf.n(), 2U);
}

TEST(Edf, ShiftMovesEveryValueAndNothingElse) {
  const Edf edf({1.0, 2.0, 4.0});
  const Edf moved = edf.shifted(0.5);
  EXPECT_THAT(moved.values(), ElementsAre(1.5, 2.5, 4.5));
  EXPECT_TRUE(std::equal(moved.levels().begin(), moved.levels().end(), edf.levels().begin()));
  EXPECT_EQ(moved.n(), 3U);
}

TEST(Edf, StepsOfHeightZeroVanish) {
  const Edf edf = Edf::fromSteps(std::vector{1.0, 2.0, 3.0, 4.0}, std::vector{0.0, 0.5, 0.5, 1.0});
  EXPECT_THAT(edf.values(), ElementsAre(2.0, 4.0));
  EXPECT_EQ(edf.n(), 0U);
}

// Fractions i/n and j/m have n + m - gcd(n, m) different values in (0, 1]; one sliver more and rounding has split a
// tie.
TEST(EachCommonLevel, EqualFractionsOfDifferentSampleSizesMeetWithoutSlivers) {
  for (const int n : {1, 3, 7, 10, 49, 100, 997}) {
    for (const int m : {1, 6, 14, 21, 30, 300, 1994, 70000}) {
      std::vector<double> a(static_cast<std::size_t>(n));
      std::vector<double> b(static_cast<std::size_t>(m));
      std::iota(a.begin(), a.end(), 0.0);
      std::iota(b.begin(), b.end(), 0.5);
      const Edf first(a);
      const Edf second(b);
      int levels = 0;
      metrics::eachCommonLevel<2>({&first, &second}, [&](const auto&) { ++levels; });
      EXPECT_EQ(levels, n + m - std::gcd(n, m)) << n << " and " << m;
    }
  }
}

TEST(Edf, RefusesWhatIsNoDistribution) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_THAT([] { Edf(std::vector<double>{}); }, ThrowsMessage<core::InputError>(HasSubstr("has no values")));
  EXPECT_THAT([&] { Edf({1.0, nan}); }, ThrowsMessage<core::InputError>(HasSubstr("value 2: is nan")));
  EXPECT_THAT([&] { Edf({-inf, 1.0}); }, ThrowsMessage<core::InputError>(HasSubstr("value 1: is -inf")));
  EXPECT_THAT([&] { Edf({1.0, inf}); }, ThrowsMessage<core::InputError>(HasSubstr("value 2: is inf")));
  EXPECT_THAT([&] { Edf({nan}); }, ThrowsMessage<core::InputError>(HasSubstr("value 1: is nan")));
  EXPECT_THAT([&] { Edf({3.0, 1.0, inf, 2.0}); }, ThrowsMessage<core::InputError>(HasSubstr("value 3: is inf")));
  const std::vector<double> two{1.0, 2.0};
  const auto weighted = [&](std::vector<double> weights) { return [&, weights] { Edf::weighted(two, weights); }; };
  EXPECT_THAT(weighted({1.0}), ThrowsMessage<core::InputError>(HasSubstr("2 values have 1 weights")));
  EXPECT_THAT(weighted({1.0, -1.0}), ThrowsMessage<core::InputError>(HasSubstr("weight 2: is -1")));
  EXPECT_THAT(weighted({0.0, 0.0}), ThrowsMessage<core::InputError>(HasSubstr("has no values")));
  EXPECT_THAT(weighted({nan, 1.0}), ThrowsMessage<core::InputError>(HasSubstr("weight 1: is nan")));
  const auto steps = [&](std::vector<double> levels) { return [&, levels] { Edf::fromSteps(two, levels); }; };
  EXPECT_THAT(steps({0.5, 0.9}), ThrowsMessage<core::InputError>(HasSubstr("is no distribution function")));
  EXPECT_THAT(steps({1.0, 0.5}), ThrowsMessage<core::InputError>(HasSubstr("is no distribution function")));
  EXPECT_THAT(
      [] {
        Edf::fromSteps(std::vector{2.0, 1.0}, std::vector{0.5, 1.0});
      },
      ThrowsMessage<core::InputError>(HasSubstr("values must ascend")));
}

}  // namespace
