#include "core/random.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace {

constexpr int kDraws = 200'000;

std::vector<double> drawn(double (core::Random::*draw)(), core::Random::Key key) {
  core::Random random(key);
  std::vector<double> values;
  for (int i = 0; i < kDraws; ++i) values.push_back((random.*draw)());
  return values;
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double moment(const std::vector<double>& values, int order) {
  const double centre = mean(values);
  double sum = 0.0;
  for (const double value : values) sum += std::pow(value - centre, order);
  return sum / static_cast<double>(values.size());
}

TEST(Random, SameKeyGivesTheSameNumbers) {
  const core::Random::Key key{.seed = 7, .sample = 2, .frame = 3, .beam = 4, .purpose = 5};
  core::Random a(key), b(key);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(a.uniform(), b.uniform());
}

// Streams that differ in one part of the key are uncorrelated: |r| < 5/sqrt(n).
TEST(Random, StreamsOfDifferentKeysAreUncorrelated) {
  const core::Random::Key base{.seed = 1, .sample = 1, .frame = 1, .beam = 1, .purpose = 1};
  const auto reference = drawn(&core::Random::normal, base);
  for (const core::Random::Key other :
       {core::Random::Key{.seed = 2, .sample = 1, .frame = 1, .beam = 1, .purpose = 1},
        core::Random::Key{.seed = 1, .sample = 2, .frame = 1, .beam = 1, .purpose = 1},
        core::Random::Key{.seed = 1, .sample = 1, .frame = 2, .beam = 1, .purpose = 1},
        core::Random::Key{.seed = 1, .sample = 1, .frame = 1, .beam = 2, .purpose = 1},
        core::Random::Key{.seed = 1, .sample = 1, .frame = 1, .beam = 1, .purpose = 2}}) {
    const auto values = drawn(&core::Random::normal, other);
    double product = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) product += values[i] * reference[i];
    EXPECT_LT(std::abs(product / kDraws), 5.0 / std::sqrt(kDraws));
  }
}

// Standard errors of the moments of N(0,1): 1/√n, √2/√n, √6/√n (skewness), √24/√n (kurtosis). Five of them.
TEST(Random, NormalHasTheMomentsOfTheNormalDistribution) {
  const auto values = drawn(&core::Random::normal, {.seed = 3});
  const double root = std::sqrt(static_cast<double>(kDraws));
  EXPECT_NEAR(mean(values), 0.0, 5.0 / root);
  EXPECT_NEAR(moment(values, 2), 1.0, 5.0 * std::sqrt(2.0) / root);
  EXPECT_NEAR(moment(values, 3), 0.0, 5.0 * std::sqrt(15.0) / root);
  EXPECT_NEAR(moment(values, 4), 3.0, 5.0 * std::sqrt(96.0) / root);
}

TEST(Random, UniformNeverTouchesItsEnds) {
  const auto values = drawn(&core::Random::uniform, {.seed = 4});
  for (const double value : values) ASSERT_TRUE(value > 0.0 && value < 1.0);
  EXPECT_NEAR(mean(values), 0.5, 5.0 * std::sqrt(1.0 / 12.0 / kDraws));
}

// Gamma(k): mean k, variance k; below and above shape 1, where the method changes.
TEST(Random, GammaHasMeanAndVarianceOfItsShape) {
  for (const double shape : {0.5, 3.0}) {
    core::Random random({.seed = 5});
    std::vector<double> values;
    for (int i = 0; i < kDraws; ++i) values.push_back(random.gamma(shape));
    EXPECT_NEAR(mean(values), shape, 5.0 * std::sqrt(shape / kDraws));
    EXPECT_NEAR(moment(values, 2), shape, 5.0 * std::sqrt((2.0 * shape * shape + 6.0 * shape) / kDraws));
  }
}

TEST(Random, PoissonHasItsMeanBelowAndAboveTheSwitchOfMethod) {
  for (const double expected : {0.3, 8.0, 90.0}) {
    core::Random random({.seed = 6});
    double sum = 0.0;
    for (int i = 0; i < kDraws; ++i) sum += random.poisson(expected);
    EXPECT_NEAR(sum / kDraws, expected, 5.0 * std::sqrt(expected / kDraws) + 1e-3);
  }
}

}  // namespace
