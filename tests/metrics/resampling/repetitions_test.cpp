#include "metrics/resampling/repetitions.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/error.h"
#include "metrics/samples/moment_differences.h"
#include "tests/metrics/resampling/normal_samples.h"

namespace {

using metrics::Comparison;
using metrics::FigureRepetitions;
using metrics::Repetitions;
using metrics::repetitionsForMean;
using metrics::SamplePair;
using metrics_test::normalSample;
using Values = std::vector<double>;

void differenceOfMeans(const Comparison&, const SamplePair& samples, std::span<double> results) {
  results[0] = metrics::meanDifference(samples);
}

FigureRepetitions forBias(const Values& simulated, const Values& measured, double half_width) {
  core::SilentProgress progress;
  return metrics::repetitionsForFigures(
             {.simulated = {{.values = simulated, .units = {}}}, .measured = {.values = measured, .units = {}}},
             Values{half_width}, differenceOfMeans, {}, progress)
      .front();
}

// z = 1.959964, s = sqrt(2.5), w = 1: n = 9.6037; the pilot had 5. Chi-squared with 4 degrees of freedom has the
// quantiles 0.484419 and 11.143287 (tables).
TEST(RepetitionsForMean, FollowTheClosedForm) {
  const Repetitions needed = repetitionsForMean(Values{1.0, 2.0, 3.0, 4.0, 5.0}, 1.0, 0.95);
  const double n = 1.959963984540054 * 1.959963984540054 * 2.5;
  EXPECT_NEAR(needed.factor, n / 5.0, 1e-12);
  EXPECT_NEAR(needed.low, n / 5.0 * 4.0 / 11.143286781877796, 1e-9);
  EXPECT_NEAR(needed.high, n / 5.0 * 4.0 / 0.4844185570879303, 1e-9);
  EXPECT_EQ(needed.of(5), 10u);
}

TEST(RepetitionsForMean, QuadrupleForHalfTheWidth) {
  const Values pilot = normalSample(1, 30);
  EXPECT_NEAR(repetitionsForMean(pilot, 0.05, 0.9).factor, 4.0 * repetitionsForMean(pilot, 0.1, 0.9).factor, 1e-9);
}

TEST(RepetitionsForMean, OfAPilotWithoutScatterAreTwo) {
  EXPECT_EQ(repetitionsForMean(Values{3.0, 3.0, 3.0}, 0.1, 0.95).of(3), 2u);
}

// The interval of the factor holds the true one in 95 % of 500 pilots (deviation 1 %): chi-squared is exact here.
TEST(RepetitionsForMean, HaveAnIntervalThatHoldsTheTruth) {
  const double truth = 1.959963984540054 * 1.959963984540054 / (0.1 * 0.1) / 12.0;
  int held = 0;
  for (std::uint32_t k = 0; k < 500; ++k) {
    const Repetitions needed = repetitionsForMean(normalSample(100 + k, 12), 0.1, 0.95);
    held += needed.low <= truth && truth <= needed.high ? 1 : 0;
  }
  EXPECT_NEAR(held / 500.0, 0.95, 0.04);
}

TEST(RepetitionsForMean, RefuseWhatHasNoAnswer) {
  EXPECT_THROW((void)repetitionsForMean(Values{1.0}, 0.1, 0.95), core::InputError);
  EXPECT_THROW((void)repetitionsForMean(Values{1.0, 2.0}, 0.0, 0.95), core::InputError);
  EXPECT_THROW((void)repetitionsForMean(Values{1.0, 2.0}, 0.1, 1.0), core::InputError);
  EXPECT_THROW((void)repetitionsForMean(Values{1.0, NAN}, 0.1, 0.95), core::InputError);
}

// s_x^2/n + s_y^2/m in the place of s^2/n. The width of 1000 replicates is good to 4 %, its square to 8 %, and
// variances with n in the denominator lack 2 %: 25 % are three deviations.
TEST(RepetitionsForFigures, OfTheBiasAreThoseOfTwoMeans) {
  const Values simulated = normalSample(2, 60, 0.0, 0.6);
  const Values measured = normalSample(3, 60, 0.0, 0.3);
  const FigureRepetitions needed = forBias(simulated, measured, 0.05);
  const double of_simulated = repetitionsForMean(simulated, 0.05, 0.95).factor;
  const double of_measured = repetitionsForMean(measured, 0.05, 0.95).factor;
  EXPECT_NEAR(needed.repetitions.factor / (of_simulated + of_measured), 1.0, 0.25);
  EXPECT_NEAR(needed.measured_share, of_measured / (of_simulated + of_measured), 1e-3);
  EXPECT_LT(needed.repetitions.low, needed.repetitions.factor);
  EXPECT_GT(needed.repetitions.high, needed.repetitions.factor);
}

// Taking the advice: samples larger by the factor have the wanted width. Both widths are random: within 35 %.
TEST(RepetitionsForFigures, LeadToTheWantedWidth) {
  const double half_width = 0.05;
  const FigureRepetitions pilot = forBias(normalSample(4, 40), normalSample(5, 40), half_width);
  const std::size_t n = pilot.repetitions.of(40);
  const FigureRepetitions repeated = forBias(normalSample(6, n), normalSample(7, n), half_width);
  EXPECT_NEAR(repeated.pilot.width(), 2.0 * half_width, 0.35 * 2.0 * half_width);
}

TEST(RepetitionsForFigures, RefuseAWidthOfNothing) {
  EXPECT_THROW((void)forBias({1.0, 2.0}, {1.0, 2.0}, 0.0), core::InputError);
}

}  // namespace
