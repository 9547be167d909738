#include "metrics/prediction/held_out.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"
#include "tests/metrics/prediction/error_cases.h"

namespace {

using metrics::checkHeldOut;
using metrics::ErrorSamples;
using metrics::HeldOutCheck;
using metrics::Interval;
using metrics::predict;
using metrics::Prediction;
using metrics_test::overRange;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// 0.1 x with a scatter of about 0.2.
Prediction nearlyLinear() {
  return predict(
      overRange({1, 2, 3, 4, 5, 6}, [](double x) { return 0.1 * x + (std::fmod(x, 2.0) == 0 ? 0.1 : -0.1); }));
}

TEST(HeldOut, MissesAndTheirSignsAreCounted) {
  const Prediction prediction = predict(overRange({0, 1, 2, 3}, [](double x) { return x; }));
  ErrorSamples held_out = overRange({0.5, 1.5, 2.5, 9.0}, [](double x) { return x; });
  held_out.errors = {0.5, 1.75, 2.0, 9.0};
  const HeldOutCheck check = checkHeldOut(prediction, held_out);
  EXPECT_EQ(check.n, 4u);
  EXPECT_EQ(check.extrapolated, 1u);
  EXPECT_NEAR(check.mean_miss, -0.25 / 4.0, 1e-14);
  EXPECT_NEAR(check.mean_absolute_miss, 0.75 / 4.0, 1e-14);
  EXPECT_NEAR(check.largest_miss, -0.5, 1e-14);
  EXPECT_EQ(check.largest_miss_row, 2u);
  const double misses = 0.0625 + 0.25;
  EXPECT_NEAR(check.skill_over_none, 1.0 - misses / (0.25 + 3.0625 + 4.0 + 81.0), 1e-14);
  EXPECT_NEAR(check.skill_over_mean, 1.0 - misses / (1.0 + 0.0625 + 0.25 + 56.25), 1e-14);  // mean error 1.5
}

// scipy 1.10.1: stats.binomtest(k, n).proportion_ci(0.95, 'exact').
TEST(HeldOut, CoverageHasTheIntervalOfClopperAndPearson) {
  const Prediction prediction = nearlyLinear();
  const auto coverage = [&](int covered, int n) {
    ErrorSamples held_out =
        overRange(std::vector<double>(static_cast<std::size_t>(n), 3.5), [](double) { return 0.35; });
    for (int i = covered; i < n; ++i) held_out.errors[static_cast<std::size_t>(i)] = 99.0;
    const HeldOutCheck check = checkHeldOut(prediction, held_out);
    EXPECT_EQ(check.covered, static_cast<std::size_t>(covered));
    return check.coverage;
  };
  const Interval most = coverage(17, 20);
  EXPECT_NEAR(most.low, 0.6210731734547044, 1e-9);
  EXPECT_NEAR(most.high, 0.9679290628144552, 1e-9);
  const Interval all = coverage(10, 10);  // low: 0.025^(1/10)
  EXPECT_NEAR(all.low, std::pow(0.025, 0.1), 1e-12);
  EXPECT_EQ(all.high, 1.0);
  const Interval none = coverage(0, 5);
  EXPECT_EQ(none.low, 0.0);
  EXPECT_NEAR(none.high, 1.0 - std::pow(0.025, 0.2), 1e-12);
}

// Noise as promised: the level is credible. Bounds made from a third of the noise: it is not.
TEST(HeldOut, BoundsThatAreTooNarrowAreFoundOut) {
  core::Random random({.seed = 21});
  std::vector<double> ranges;
  for (int i = 0; i < 200; ++i) ranges.push_back(0.5 * i);
  const auto with_noise = [&](double sd) {
    return overRange(ranges, [&random, sd](double x) { return 0.01 * x + sd * random.normal(); });
  };
  const Prediction honest = predict(with_noise(0.3));
  const Prediction narrow = predict(with_noise(0.1));
  const ErrorSamples held_out = with_noise(0.3);
  EXPECT_TRUE(checkHeldOut(honest, held_out).holds(honest));
  EXPECT_FALSE(checkHeldOut(narrow, held_out).holds(narrow));
  EXPECT_GT(checkHeldOut(honest, held_out).skill_over_none, 0.0);
}

TEST(HeldOut, SkillIsUndefinedWhereTheSimulationWasRight) {
  const HeldOutCheck check = checkHeldOut(nearlyLinear(), overRange({2, 3}, [](double) { return 0.0; }));
  EXPECT_TRUE(std::isnan(check.skill_over_none));
}

TEST(HeldOut, RefusesSamplesOverOtherParameters) {
  ErrorSamples other = overRange({1, 2}, [](double x) { return x; });
  other.parameters = {"angle_deg"};
  EXPECT_THAT([&] { (void)checkHeldOut(nearlyLinear(), other); },
              ThrowsMessage<core::InputError>(HasSubstr("angle_deg; the prediction is over range_m")));
}

}  // namespace
