#include "metrics/distributions/mixture.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>

#include "core/error.h"
#include "metrics/distributions/box_bounds.h"
#include "tests/metrics/random_cases.h"

namespace {

using metrics::Edf;
using metrics::mixture;
using metrics::PBox;
using metrics_test::RandomCases;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

std::vector<double> weightsFor(std::size_t parts, RandomCases& cases) {
  std::vector<double> weights(parts);
  for (double& w : weights) w = cases.uniform(0.1, 3.0);
  return weights;
}

TEST(Mixture, StepsWhereAPartStepsByItsWeight) {
  const std::vector<Edf> parts{Edf({0.0, 2.0}), Edf({1.0})};
  const Edf edf = mixture(parts, std::vector{1.0, 3.0});
  EXPECT_THAT(edf.values(), ElementsAre(0.0, 1.0, 2.0));
  EXPECT_THAT(edf.levels(), ElementsAre(0.125, 0.875, 1.0));
}

// F(x) = sum w_i F_i(x) / sum w_i, read literally. Up to 6 terms: some roundings.
TEST(Mixture, IsTheWeightedMeanOfTheDistributionFunctions) {
  RandomCases cases(80);
  for (int k = 0; k < 300; ++k) {
    const std::vector<Edf> parts = cases.runs(6);
    const std::vector<double> weights = weightsFor(parts.size(), cases);
    const Edf edf = mixture(parts, weights);
    for (const Edf& part : parts) {
      for (const double x : part.values()) {
        double sum = 0.0;
        double total = 0.0;
        for (std::size_t i = 0; i < parts.size(); ++i) {
          sum += weights[i] * parts[i].cdf(x);
          total += weights[i];
        }
        EXPECT_NEAR(edf.cdf(x), sum / total, 1e-14);
      }
    }
  }
}

TEST(Mixture, WeightedBySampleSizesIsThePooledSample) {
  RandomCases cases(81);
  for (int k = 0; k < 200; ++k) {
    std::vector<Edf> parts;
    std::vector<double> weights;
    std::vector<double> pooled;
    for (int i = 0; i < 4; ++i) {
      const std::vector<double> sample = cases.sample();
      pooled.insert(pooled.end(), sample.begin(), sample.end());
      parts.emplace_back(sample);
      weights.push_back(static_cast<double>(sample.size()));
    }
    const Edf mixed = mixture(parts, weights);
    const Edf expected(pooled);
    ASSERT_TRUE(
        std::equal(mixed.values().begin(), mixed.values().end(), expected.values().begin(), expected.values().end()));
    for (std::size_t i = 0; i < mixed.levels().size(); ++i) {
      EXPECT_NEAR(mixed.levels()[i], expected.levels()[i], 1e-14);
    }
  }
}

TEST(Mixture, HasTheWeightedMeanOfTheMeans) {
  RandomCases cases(82);
  for (int k = 0; k < 200; ++k) {
    const std::vector<PBox> parts{cases.box(), cases.box(), cases.box()};
    const std::vector<double> weights{1.0, 2.0, 5.0};
    const metrics::Interval mean = metrics::meanInterval(mixture(parts, weights));
    double low = 0.0;
    double high = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      low += weights[i] / 8.0 * parts[i].left().mean();
      high += weights[i] / 8.0 * parts[i].right().mean();
    }
    EXPECT_NEAR(mean.low, low, 1e-13);
    EXPECT_NEAR(mean.high, high, 1e-13);
  }
}

// A weight of a power of two does not round: exactly that part.
TEST(Mixture, OfOnePartIsThatPart) {
  RandomCases cases(83);
  const PBox box = cases.box();
  const std::vector<PBox> parts{box, cases.box()};
  const PBox mixed = mixture(parts, std::vector{0.25, 0.0});
  EXPECT_EQ(mixed.left(), box.left());
  EXPECT_EQ(mixed.right(), box.right());
}

TEST(Mixture, OfSingleDistributionsIsOne) {
  const std::vector<PBox> parts{Edf({1.0}), Edf({2.0})};
  EXPECT_TRUE(mixture(parts, std::vector{1.0, 1.0}).isSingleDistribution());
}

// Any choice of one distribution per box gives a mixture inside: no tolerance. The envelope contains every mixture too,
// but for the rounding of (w a + v a) / (w + v).
TEST(Mixture, OfBoxesHoldsTheMixturesOfWhatTheyHold) {
  RandomCases cases(84);
  for (int k = 0; k < 200; ++k) {
    const std::vector<Edf> a = cases.runs();
    const std::vector<Edf> b = cases.runs();
    const std::vector<double> weights = weightsFor(2, cases);
    const std::vector<PBox> boxes{PBox::envelope(a), PBox::envelope(b)};
    const PBox mixed = mixture(boxes, weights);
    const std::vector<Edf> edges{boxes[0].left(), boxes[0].right(), boxes[1].left(), boxes[1].right()};
    const PBox envelope = PBox::envelope(edges);
    for (const Edf& from_a : a) {
      for (const Edf& from_b : b) {
        const Edf inside = mixture(std::vector<Edf>{from_a, from_b}, weights);
        EXPECT_TRUE(metrics::contains(mixed, inside));
        for (const double x : inside.values()) {
          EXPECT_GE(inside.cdf(x), metrics::probabilityInterval(envelope, x).low - 1e-15);
          EXPECT_LE(inside.cdf(x), metrics::probabilityInterval(envelope, x).high + 1e-15);
        }
      }
    }
  }
}

// The tree of sums adds other pairs when parts are exchanged: equal but for rounding.
TEST(Mixture, IsIndependentOfTheOrderOfParts) {
  RandomCases cases(85);
  for (int k = 0; k < 100; ++k) {
    std::vector<Edf> parts = cases.runs(7);
    std::vector<double> weights = weightsFor(parts.size(), cases);
    const Edf edf = mixture(parts, weights);
    std::reverse(parts.begin(), parts.end());
    std::reverse(weights.begin(), weights.end());
    const Edf other = mixture(parts, weights);
    for (const double x : edf.values()) EXPECT_NEAR(edf.cdf(x), other.cdf(x), 1e-14);
  }
}

TEST(Mixture, DependsOnlyOnTheRatiosOfWeightsHoweverLarge) {
  const std::vector<Edf> parts{Edf({0.0}), Edf({1.0})};
  EXPECT_THAT(mixture(parts, std::vector{1e308, 1e308}).levels(), ElementsAre(0.5, 1.0));
  EXPECT_THAT(mixture(parts, std::vector{1e-320, 1e-320}).levels(), ElementsAre(0.5, 1.0));
}

TEST(Mixture, RefusesWeightsThatAreNone) {
  const std::vector<Edf> parts{Edf({0.0}), Edf({1.0})};
  const auto with = [&](std::vector<double> weights) { return [&parts, weights] { (void)mixture(parts, weights); }; };
  EXPECT_THAT(with({1.0}), ThrowsMessage<core::InputError>(HasSubstr("2 parts of a mixture have 1 weights")));
  EXPECT_THAT(with({1.0, -1.0}), ThrowsMessage<core::InputError>(HasSubstr("weight 2: is -1")));
  EXPECT_THAT(with({std::numeric_limits<double>::infinity(), 1.0}),
              ThrowsMessage<core::InputError>(HasSubstr("weight 1: is inf")));
  EXPECT_THAT(with({0.0, 0.0}), ThrowsMessage<core::InputError>(HasSubstr("at least one part")));
  EXPECT_THAT([] { (void)mixture(std::vector<Edf>{}, std::vector<double>{}); },
              ThrowsMessage<core::InputError>(HasSubstr("at least one part")));
}

}  // namespace
