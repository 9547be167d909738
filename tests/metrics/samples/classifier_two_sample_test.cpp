#include "metrics/samples/classifier_two_sample.h"

#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <string>

#include "core/error.h"
#include "core/parallel.h"
#include "core/random.h"

namespace {

using metrics::ClassifierOptions;
using metrics::ClassifierTwoSample;
using metrics::classifierTwoSampleTest;

class Points {
 public:
  explicit Points(std::uint64_t seed) : random_({.seed = seed}) {}

  std::vector<double> normal(std::size_t n, double mean = 0.0, double deviation = 1.0) {
    std::vector<double> values(n);
    for (double& x : values) x = mean + deviation * random_.normal();
    return values;
  }
  /// Two features, each N(0, 1).
  std::vector<double> pairs(std::size_t n, double correlation) {
    std::vector<double> values;
    for (std::size_t i = 0; i < n; ++i) {
      const double first = random_.normal();
      values.push_back(first);
      values.push_back(correlation * first + std::sqrt(1.0 - correlation * correlation) * random_.normal());
    }
    return values;
  }

 private:
  core::Random random_;
};

ClassifierTwoSample test(const std::vector<double>& simulated, const std::vector<double>& measured,
                         const ClassifierOptions& options = {}, std::size_t dimension = 1) {
  return classifierTwoSampleTest({.simulated = simulated, .measured = measured, .dimension = dimension}, options);
}

// Of 10 + 10 tested points all are told right: one arrangement of C(20, 10) = 184756.
TEST(ClassifierTwoSample, OfDisjointSamplesIsAlwaysRight) {
  Points points(1);
  const auto apart = test(points.normal(20, 100.0), points.normal(20));
  EXPECT_EQ(apart.accuracy, 1.0);
  EXPECT_NEAR(apart.p_value * 184756.0, 1.0, 1e-9);
  EXPECT_EQ(apart.simulated, 10u);
  EXPECT_EQ(apart.measured, 10u);
  EXPECT_EQ(apart.neighbours, 4u);  // floor(sqrt(20))
  const auto validated = test(points.normal(20, 100.0), points.normal(30), {.permutations = 99});
  EXPECT_EQ(validated.accuracy, 1.0);
  EXPECT_EQ(validated.p_value, 0.01);
  EXPECT_EQ(validated.simulated, 20u);
  EXPECT_EQ(validated.measured, 30u);
}

// The p-value is exact and hence at most alpha in a share alpha of equal pairs; the hypergeometric steps make it less.
// 1000 pairs: standard error 0.95 % at 10 %.
TEST(ClassifierTwoSample, PValueOfEqualDistributionsIsValid) {
  Points points(2);
  int small = 0;
  double accuracy = 0.0;
  for (std::uint64_t k = 0; k < 1000; ++k) {
    const auto equal = test(points.normal(60), points.normal(80), {.seed = k});
    small += equal.p_value <= 0.1 ? 1 : 0;
    accuracy += equal.accuracy / 1000.0;
  }
  EXPECT_LE(small / 1000.0, 0.1 + 4 * 0.0095);
  EXPECT_GE(small / 1000.0, 0.05);
  EXPECT_NEAR(accuracy, 0.5, 4.0 * std::sqrt(0.25 / 70.0 / 1000.0));
}

TEST(ClassifierTwoSample, PermutationPValueOfEqualDistributionsIsValid) {
  Points points(3);
  int small = 0;
  for (std::uint64_t k = 0; k < 300; ++k) {
    small += test(points.normal(25), points.normal(25), {.permutations = 39, .seed = k}).p_value <= 0.1 ? 1 : 0;
  }
  EXPECT_NEAR(small / 300.0, 0.1, 4 * 0.0173 + 0.01);
}

// Two normals, b deviations apart: the best any classifier can do is Phi(b/2). A vote of sqrt(n) loses some per cent.
TEST(ClassifierTwoSample, ComesCloseToTheBestClassifierOfNormals) {
  Points points(4);
  for (const double b : {0.5, 1.0, 2.0}) {
    const double best = boost::math::cdf(boost::math::normal(), b / 2.0);
    const auto shifted = test(points.normal(8000, b), points.normal(8000));
    EXPECT_NEAR(shifted.accuracy, best, 0.02) << b;
    EXPECT_LT(shifted.p_value, 1e-6) << b;
  }
}

TEST(ClassifierTwoSample, SeesASpreadThatTheMeanHides) {
  Points points(5);
  EXPECT_LT(test(points.normal(500, 22.0, 0.6), points.normal(500, 22.0, 0.2)).p_value, 1e-6);
}

// Each feature alone is N(0, 1) in both samples.
TEST(ClassifierTwoSample, SeesACorrelationThatNoSingleFeatureShows) {
  Points points(6);
  const auto correlated = points.pairs(1000, 0.8);
  const auto independent = points.pairs(1000, 0.0);
  EXPECT_LT(test(correlated, independent, {}, 2).p_value, 1e-6);
  const auto firstOf = [](const std::vector<double>& pairs) {
    std::vector<double> first;
    for (std::size_t i = 0; i < pairs.size(); i += 2) first.push_back(pairs[i]);
    return first;
  };
  EXPECT_GT(test(firstOf(correlated), firstOf(independent)).p_value, 0.01);
}

TEST(ClassifierTwoSample, UnitsDoNotMatter) {
  Points points(7);
  auto simulated = points.pairs(200, 0.5);
  auto measured = points.pairs(300, 0.0);
  const auto before = test(simulated, measured, {}, 2);
  for (auto* sample : {&simulated, &measured}) {
    for (std::size_t i = 0; i < sample->size(); i += 2) (*sample)[i] *= 1024.0;  // exact, in km instead of m or so
  }
  const auto after = test(simulated, measured, {}, 2);
  EXPECT_EQ(after.accuracy, before.accuracy);
  EXPECT_EQ(after.p_value, before.p_value);
}

TEST(ClassifierTwoSample, EqualValuesCannotBeTold) {
  const std::vector<double> same(50, 3.0);
  const auto equal = test(same, same);
  EXPECT_EQ(equal.accuracy, 0.5);
  EXPECT_EQ(equal.p_value, 1.0);
}

TEST(ClassifierTwoSample, SameSeedSameResultOnAnyNumberOfThreads) {
  Points points(8);
  const auto simulated = points.normal(2000, 0.1);
  const auto measured = points.normal(2000);
  const auto all = test(simulated, measured, {.seed = 3});
  core::limitThreads(1);
  const auto one = test(simulated, measured, {.seed = 3});
  core::limitThreads(0);
  EXPECT_EQ(all.accuracy, one.accuracy);
  EXPECT_EQ(all.p_value, one.p_value);
}

// 10^5 counters of 4 cm each: nearly all values are ties, and the p-value is a sum of many terms.
TEST(ClassifierTwoSample, TakesManyTiedValues) {
  Points points(9);
  auto simulated = points.normal(100000, 22.0, 0.2);
  auto measured = points.normal(100000, 22.05, 0.2);
  for (auto* sample : {&simulated, &measured}) {
    for (double& x : *sample) x = 0.04 * std::round(x / 0.04);
  }
  const auto shifted = test(simulated, measured);
  EXPECT_NEAR(shifted.accuracy, boost::math::cdf(boost::math::normal(), 0.125), 0.01);
  EXPECT_LT(shifted.p_value, 1e-6);
}

void expectItem(const std::string& item, const std::vector<double>& simulated, const std::vector<double>& measured,
                std::size_t dimension, const ClassifierOptions& options = {}) {
  try {
    (void)test(simulated, measured, options, dimension);
    FAIL() << item;
  } catch (const core::InputError& error) {
    EXPECT_EQ(error.place().item, item);
  }
}

TEST(ClassifierTwoSample, RefusesWhatItCannotTest) {
  const std::vector<double> four = {1.0, 2.0, 3.0, 4.0};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expectItem("measured row 2, column 1", four, {1.0, 2.0, nan, 4.0}, 2);
  expectItem("simulated points", {1.0, 2.0, 3.0}, four, 2);
  expectItem("simulated points", {}, four, 1);
  expectItem("measured points", four, {1.0}, 1);
  expectItem("simulated points", four, four, 1, {.permutations = 9});  // five folds of four points
  expectItem("dimension", four, four, 0);
  expectItem("folds", four, four, 1, {.permutations = 9, .folds = 1});
  expectItem("", four, four, 1, {.permutations = 2'000'000, .folds = 2});
}

}  // namespace
