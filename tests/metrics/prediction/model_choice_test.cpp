#include "metrics/prediction/model_choice.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"
#include "tests/metrics/prediction/error_cases.h"

namespace {

using metrics::Candidate;
using metrics::chooseFamily;
using metrics::ErrorSamples;
using metrics::Family;
using metrics::ModelChoice;
using metrics_test::overRange;
using testing::HasSubstr;
using testing::ThrowsMessage;

const std::vector<double> kRanges{2, 5, 9, 14, 20, 27, 35, 44, 54, 65, 77, 90};

const Candidate& of(const ModelChoice& choice, Family family) {
  return choice.candidates.at(static_cast<std::size_t>(family));
}

// Leaving one out of n from a mean misses by n / (n - 1) times the deviation: 0, 1, 5 are missed by 3, 1.5 and 4.5.
TEST(ModelChoice, ScoreOfTheConstantFollowsTheClosedForm) {
  const ModelChoice choice = chooseFamily(overRange({1, 2, 3}, [](double x) {
    return x == 1 ? 0.0 : x == 2 ? 1.0 : 5.0;
  }));
  EXPECT_NEAR(of(choice, Family::Constant).score.value(), std::sqrt((9.0 + 2.25 + 20.25) / 3.0), 1e-14);
  EXPECT_EQ(choice.folds, 3u);
}

// Of a linear fit a left-out residual is e / (1 - h): the identity by which leave-one-out needs one fit only.
TEST(ModelChoice, ScoreOfTheLineIsThePressStatistic) {
  core::Random random({.seed = 11});
  const ErrorSamples samples = overRange(kRanges, [&](double x) { return 0.01 * x + random.normal(); });
  double mean_x = 0.0;
  double mean_y = 0.0;
  const auto n = static_cast<double>(kRanges.size());
  for (std::size_t i = 0; i < kRanges.size(); ++i) {
    mean_x += kRanges[i] / n;
    mean_y += samples.errors[i] / n;
  }
  double sxx = 0.0;
  double sxy = 0.0;
  for (std::size_t i = 0; i < kRanges.size(); ++i) {
    sxx += (kRanges[i] - mean_x) * (kRanges[i] - mean_x);
    sxy += (kRanges[i] - mean_x) * (samples.errors[i] - mean_y);
  }
  double squares = 0.0;
  for (std::size_t i = 0; i < kRanges.size(); ++i) {
    const double dx = kRanges[i] - mean_x;
    const double residual = samples.errors[i] - mean_y - sxy / sxx * dx;
    const double miss = residual / (1.0 - 1.0 / n - dx * dx / sxx);
    squares += miss * miss;
  }
  EXPECT_NEAR(of(chooseFamily(samples), Family::Linear).score.value(), std::sqrt(squares / n), 1e-12);
}

TEST(ModelChoice, NoiseFreeDataShowTheirFamily) {
  const auto chosen = [](auto truth) { return chooseFamily(overRange(kRanges, truth)).family; };
  EXPECT_EQ(chosen([](double) { return 0.7; }), Family::Constant);
  EXPECT_EQ(chosen([](double x) { return 0.1 + 0.02 * x; }), Family::Linear);  // ties with the quadratic
  EXPECT_EQ(chosen([](double x) { return 0.1 - 0.02 * x + 1e-4 * x * x; }), Family::Quadratic);
  EXPECT_EQ(chosen([](double x) { return 0.1 + 0.5 * std::exp(-0.06 * x); }), Family::Exponential);
  EXPECT_EQ(chosen([](double x) { return 0.1 + 0.5 / (1.0 + std::exp(6.0 - 0.2 * x)); }), Family::Sigmoid);
}

TEST(ModelChoice, TooFewPointsAreSaidForEachFamily) {
  const ModelChoice choice = chooseFamily(overRange({1, 2, 3}, [](double x) { return x; }));
  EXPECT_EQ(choice.family, Family::Linear);
  EXPECT_TRUE(of(choice, Family::Linear).reason.empty());
  EXPECT_FALSE(of(choice, Family::Quadratic).score);
  EXPECT_THAT(of(choice, Family::Quadratic).reason, HasSubstr("3 coefficients; 2 rows are too few"));
  EXPECT_THAT(of(choice, Family::Sigmoid).reason, HasSubstr("4 coefficients"));
}

// Two set-ups a range, each with its own error that its ten rows share: the errors scatter about a constant. Rows left
// out alone are predicted from their own set-up; whole set-ups are not.
TEST(ModelChoice, RowsOfOneSetupStayTogether) {
  ErrorSamples samples{.target = "d_bias", .parameters = {"range_m"}, .points = {}, .errors = {}};
  const std::vector<double> shared{0.3, -0.3, 0.25, -0.35, 0.3};
  for (std::size_t setup = 0; setup < shared.size(); ++setup) {
    for (int repetition = 0; repetition < 10; ++repetition) {
      samples.points.push_back(10.0 * static_cast<double>(setup));
      samples.errors.push_back(shared[setup] + 0.001 * repetition);
      samples.setups.push_back(std::to_string(setup));
    }
  }
  const ModelChoice grouped = chooseFamily(samples);
  EXPECT_EQ(grouped.folds, 5u);
  EXPECT_EQ(grouped.family, Family::Constant);
  samples.setups.clear();
  const ModelChoice alone = chooseFamily(samples);
  EXPECT_EQ(alone.folds, 50u);
  EXPECT_LT(of(alone, Family::Constant).score.value(), of(grouped, Family::Constant).score.value());
}

TEST(ModelChoice, ARowWithoutSetupIsItsOwn) {
  ErrorSamples samples = overRange({1, 2, 3, 4, 5}, [](double x) { return x; });
  samples.setups = {"a", "", "a", "", "b"};
  EXPECT_EQ(chooseFamily(samples).folds, 4u);
  EXPECT_EQ(chooseFamily(samples, {.folds = 2}).folds, 2u);
}

TEST(ModelChoice, ManySamplesAreSplitIntoTen) {
  std::vector<double> ranges;
  for (int i = 0; i < 51; ++i) ranges.push_back(i);
  const ErrorSamples samples = overRange(ranges, [](double x) { return 0.1 * x; });
  const std::array families{Family::Linear};
  EXPECT_EQ(chooseFamily(samples, {.families = families}).folds, 10u);
  EXPECT_EQ(chooseFamily(samples, {.families = families, .folds = 51}).folds, 51u);
}

TEST(ModelChoice, IsTheSameEveryTime) {
  core::Random random({.seed = 12});
  const ErrorSamples samples =
      overRange(kRanges, [&](double x) { return std::exp(-0.05 * x) + 0.1 * random.normal(); });
  const ModelChoice once = chooseFamily(samples);
  const ModelChoice again = chooseFamily(samples);
  EXPECT_EQ(once.family, again.family);
  for (std::size_t k = 0; k < once.candidates.size(); ++k) {
    EXPECT_EQ(once.candidates[k].score, again.candidates[k].score);
  }
}

TEST(ModelChoice, OnlyFamiliesAskedForAreTried) {
  const std::array families{Family::Quadratic, Family::Linear};
  const ModelChoice choice = chooseFamily(overRange(kRanges, [](double x) { return x; }), {.families = families});
  ASSERT_EQ(choice.candidates.size(), 2u);
  EXPECT_EQ(choice.candidates[0].family, Family::Linear);
}

TEST(ModelChoice, RefusesWhatCannotBeTriedOut) {
  EXPECT_THAT([] { (void)chooseFamily(overRange({1}, [](double x) { return x; })); },
              ThrowsMessage<core::InputError>(HasSubstr("only one row or set-up")));
  const ErrorSamples three = overRange({1, 2, 3}, [](double x) { return x; });
  EXPECT_THAT([&] { (void)chooseFamily(three, {.folds = 4}); },
              ThrowsMessage<core::InputError>(HasSubstr("2 to 3 are possible")));
  EXPECT_THAT([&] { (void)chooseFamily(three, {.families = std::array{Family::Sigmoid}}); },
              ThrowsMessage<core::InputError>(HasSubstr("no family can be tried out")));
}

}  // namespace
