#include "metrics/prediction/prediction.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"
#include "tests/metrics/prediction/error_cases.h"

namespace {

using metrics::atLevel;
using metrics::ErrorSamples;
using metrics::Family;
using metrics::predict;
using metrics::PredictedError;
using metrics::Prediction;
using metrics_test::overRange;
using metrics_test::overTwo;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

PredictedError at(const Prediction& prediction, double x) { return prediction.at(std::array{x}); }
PredictedError at(const Prediction& prediction, double x, double y) { return prediction.at(std::array{x, y}); }

// A line through 1, 2, 3 m with errors 0, 1, 0: mean 1/3, slope 0, s^2 = 2/3. At the middle h = 1/3.
// t(0.975; 1) = tan(0.475 pi), the quantile of the Cauchy distribution.
TEST(Prediction, BoundsOfThreePointsFollowTheClosedForm) {
  const Prediction prediction = predict(overRange({1, 2, 3}, [](double x) { return x == 2 ? 1.0 : 0.0; }));
  const double t = std::tan(0.475 * std::acos(-1.0));
  const PredictedError middle = at(prediction, 2.0);
  EXPECT_NEAR(middle.value, 1.0 / 3.0, 1e-15);
  EXPECT_NEAR(middle.confidence.high - middle.value, t * std::sqrt(2.0) / 3.0, 1e-12);
  EXPECT_NEAR(middle.value - middle.observation.low, t * std::sqrt(8.0) / 3.0, 1e-12);
  const PredictedError beyond = at(prediction, 4.0);  // h = 1/3 + 2^2 / 2
  EXPECT_NEAR(beyond.confidence.high - beyond.value, t * std::sqrt(2.0 / 3.0 * 7.0 / 3.0), 1e-12);
}

// Each interval covers at 95 %: a repetition is a Bernoulli trial. 2000 of them: standard error 0.0049, taken four
// times.
TEST(Prediction, NinetyFivePercentBoundsCoverNinetyFivePercent) {
  constexpr int kRepetitions = 2000;
  const double tolerance = 4.0 * std::sqrt(0.95 * 0.05 / kRepetitions);
  core::Random random({.seed = 3});
  const auto truth = [](double x) { return 0.02 + 0.001 * x - 1e-5 * x * x; };
  int mean_covered = 0;
  int next_covered = 0;
  for (int k = 0; k < kRepetitions; ++k) {
    const auto noisy = [&](double x) { return truth(x) + 0.01 * random.normal(); };
    const Prediction prediction = predict(overRange({5, 10, 18, 30, 41, 60, 80}, noisy), {.family = Family::Quadratic});
    const PredictedError error = at(prediction, 70.0);
    mean_covered += error.confidence.contains(truth(70.0));
    next_covered += error.observation.contains(noisy(70.0));
  }
  EXPECT_NEAR(mean_covered / double{kRepetitions}, 0.95, tolerance);
  EXPECT_NEAR(next_covered / double{kRepetitions}, 0.95, tolerance);
}

// Delta method: approximate, here with noise of 2 % of the curve's height. Within 3 % of the promised coverage, of
// which four standard errors of 1000 repetitions are 2.8 %.
TEST(Prediction, BoundsOfACurveCoverApproximately) {
  core::Random random({.seed = 4});
  const auto truth = [](double x) { return 0.5 * std::exp(-0.05 * x); };
  int covered = 0;
  for (int k = 0; k < 1000; ++k) {
    const auto noisy = [&](double x) { return truth(x) + 0.01 * random.normal(); };
    const Prediction prediction =
        predict(overRange({1, 4, 9, 15, 22, 30, 45, 60, 80}, noisy), {.family = Family::Exponential});
    EXPECT_FALSE(prediction.regression.boundsAreExact());
    const PredictedError error = at(prediction, 12.0);
    covered += error.confidence.contains(truth(12.0));
  }
  EXPECT_NEAR(covered / 1000.0, 0.95, 0.03);
}

TEST(Prediction, HigherLevelsAskForWiderBounds) {
  core::Random random({.seed = 5});
  const Prediction prediction = predict(overRange({1, 2, 5, 7, 9}, [&](double) { return random.normal(); }));
  double last = 0.0;
  for (const double level : {0.5, 0.8, 0.95, 0.99, 0.9999}) {
    const PredictedError error = at(atLevel(prediction, level), 4.0);
    EXPECT_GT(error.confidence.high - error.value, last);
    EXPECT_GT(error.observation.high, error.confidence.high);
    EXPECT_LT(error.observation.low, error.confidence.low);
    last = error.confidence.high - error.value;
  }
  for (const double level : {0.0, 1.0, -1.0, 95.0, std::nan("")}) {
    EXPECT_THROW((void)atLevel(prediction, level), core::InputError) << level;
  }
}

TEST(Prediction, WithoutDegreesOfFreedomBoundsAreInfinite) {
  const PredictedError error = at(predict(overRange({1, 2}, [](double x) { return x; })), 1.5);
  EXPECT_NEAR(error.value, 1.5, 1e-15);
  EXPECT_EQ(error.confidence.low, -kInfinity);
  EXPECT_EQ(error.confidence.high, kInfinity);
  EXPECT_EQ(error.observation.high, kInfinity);
}

TEST(Prediction, AnErrorThatIsNeverNegativeIsCutAtZero) {
  const auto falling = [](double x) { return x == 2 ? 0.35 : 0.5 - 0.1 * x; };
  const Prediction prediction = predict(overRange({1, 2, 3, 4}, falling), {.never_negative = true});
  const PredictedError beyond = at(prediction, 9.0);
  EXPECT_EQ(beyond.value, 0.0);
  EXPECT_EQ(beyond.confidence.low, 0.0);
  EXPECT_EQ(beyond.observation.low, 0.0);
  EXPECT_GE(beyond.confidence.high, 0.0);
  EXPECT_LT(at(predict(overRange({1, 2, 3, 4}, falling)), 9.0).value, 0.0);
  const Prediction exact = predict(overRange({1, 2}, [](double x) { return x; }), {.never_negative = true});
  EXPECT_EQ(at(exact, 1.0).confidence.low, 0.0);
  EXPECT_EQ(at(exact, 1.0).confidence.high, kInfinity);
}

TEST(Prediction, LargestBoundKeepsItsSign) {
  const auto tilted = [](double sign) {
    return at(predict(overRange({1, 2, 3, 4}, [=](double x) { return sign * (x + (x == 2 ? 0.1 : 0.0)); })), 4.0);
  };
  EXPECT_GT(tilted(1.0).largest(), 4.0);
  EXPECT_LT(tilted(-1.0).largest(), -4.0);
}

TEST(Prediction, MarksTheParameterThatIsOutside) {
  const Prediction prediction = predict(overTwo(20, [](double x, double y) { return x - y; }));
  EXPECT_FALSE(at(prediction, 50.0, 30.0).extrapolated());
  EXPECT_EQ(at(prediction, 101.0, 30.0).outside, 1u);
  EXPECT_EQ(at(prediction, 50.0, -1.0).outside, 2u);
  EXPECT_EQ(at(prediction, 101.0, 61.0).outside, 3u);
}

// Samples along a diagonal band: the far corner has every parameter in range and no sample near.
TEST(Prediction, MarksCombinationsThatNoSampleComesNear) {
  ErrorSamples samples{.target = "d_bias", .parameters = {"a", "b"}, .points = {}, .errors = {}};
  for (int i = 0; i <= 10; ++i) {
    samples.points.insert(samples.points.end(), {1.0 * i, i + (i % 2) * 0.5});
    samples.errors.push_back(0.1 * i);
  }
  const Prediction prediction = predict(samples);
  const PredictedError corner = at(prediction, 9.0, 1.0);
  EXPECT_EQ(corner.outside, 0u);
  EXPECT_TRUE(corner.outside_joint);
  EXPECT_FALSE(at(prediction, 5.0, 5.2).extrapolated());
  for (std::size_t row = 0; row < samples.size(); ++row) EXPECT_FALSE(prediction.at(samples.point(row)).extrapolated());
}

// The hull's corners are samples, and leverage is convex: no point between samples has more than they have.
TEST(Prediction, NoMixtureOfSamplesIsAnExtrapolation) {
  core::Random random({.seed = 6});
  const ErrorSamples samples = overTwo(12, [](double x, double y) { return x * y; });
  const Prediction prediction = predict(samples, {.family = Family::Constant});
  for (int k = 0; k < 500; ++k) {
    std::array<double, 3> shares{random.uniform(), random.uniform(), random.uniform()};
    const double sum = shares[0] + shares[1] + shares[2];
    std::array<double, 2> point{};
    for (const double share : shares) {
      const auto corner = samples.point(random.below(12));
      for (std::size_t i = 0; i < 2; ++i) point[i] += share / sum * corner[i];
    }
    EXPECT_FALSE(prediction.at(point).outside_joint);
  }
}

TEST(Prediction, ACurveThatLeavesTheRangeOfNumbersHasInfiniteBounds) {
  const Prediction prediction =
      predict(overRange({1, 2, 3, 4, 5, 6}, [](double x) { return std::exp(x) + (x == 3 ? 0.1 : 0.0); }),
              {.family = Family::Exponential});
  const PredictedError error = at(prediction, 5000.0);
  EXPECT_EQ(error.confidence.high, kInfinity);
  EXPECT_EQ(error.confidence.low, -kInfinity);
  EXPECT_TRUE(error.extrapolated());
}

TEST(Prediction, RefusesAPointOfAnotherKind) {
  const Prediction prediction = predict(overRange({1, 2, 3}, [](double x) { return x; }));
  EXPECT_THAT([&] { (void)at(prediction, 1.0, 2.0); },
              ThrowsMessage<core::InputError>(HasSubstr("2 numbers is asked for; it is predicted over 1")));
  EXPECT_THAT([&] { (void)at(prediction, std::nan("")); }, ThrowsMessage<core::InputError>(HasSubstr("range_m")));
}

}  // namespace
