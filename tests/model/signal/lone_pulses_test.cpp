#include "model/signal/lone_pulses.h"

#include <cmath>
#include <gtest/gtest.h>

#include "model/signal/waveform.h"

namespace model {
namespace {

ChainSettings settingsWith(RangeMode mode) {
  ChainSettings settings;
  settings.emitter.pulse_fwhm_ns = 5.0;
  settings.receiver.threshold_w = 1.0;
  settings.detection.range_mode = mode;
  return settings;
}

/// Beams differ in their noise by up to a factor of three.
double noiseOf_w(std::uint32_t beam, double least_w) { return least_w * (1.0 + beam % 3); }

LonePulses manyPulses(double least_noise_w = 0.0) {
  LonePulses lone;
  for (std::uint32_t i = 0; i < 37; ++i) lone.add(i, {10.0 + i, 0.5 * std::pow(1.6, i)}, noiseOf_w(i, least_noise_w));
  return lone;
}

// Without noise: nothing below the threshold, EPW = c · FWHM · sqrt(log2(P/P_th)) above it.
TEST(LonePulses, WidthIsTheClosedForm) {
  LonePulses lone = manyPulses();
  lone.fire(settingsWith(RangeMode::kPeak), {.seed = 1}, std::vector<double>(lone.size(), 1.0));
  for (std::size_t i = 0; i < lone.size(); ++i) {
    const double power = 0.5 * std::pow(1.6, i);
    ASSERT_EQ(lone.detected(i), power > 1.0);
    if (!lone.detected(i)) continue;
    EXPECT_NEAR(lone.echo(i).epw_m, 0.299792458 * 5.0 * std::sqrt(std::log2(power)), 1e-12);
    EXPECT_EQ(lone.echo(i).range_m, 10.0 + static_cast<double>(i));
    EXPECT_EQ(lone.echo(i).peak_w, power);
  }
}

// A sampled waveform of two pulses so far apart that neither touches the other: crossings to two microns, see there.
TEST(LonePulses, AgreeWithTheSampledWaveform) {
  const ChainSettings settings = settingsWith(RangeMode::kLeadingEdge);
  const double width_m = 0.299792458 * 5.0 / 2.0;
  for (const double power : {1.3, 7.0, 400.0}) {
    // Two halves at the same place: the waveform sums them sample by sample.
    const std::vector<Pulse> halves{{20.0, power / 2}, {20.0, power / 2}};
    std::vector<Stretch> stretches;
    WaveformPart({halves, 10.0, 30.0, 10.0}, {width_m, {}}, 0.1).stretchesAbove(1.0, stretches);
    const auto echo = loneEcho({20.0, power}, settings.receiver, settings, 1.0, {});
    ASSERT_EQ(stretches.size(), 1U);
    ASSERT_TRUE(echo.has_value());
    EXPECT_NEAR(echo->range_m, stretches[0].rise_m, 2e-6);
    EXPECT_NEAR(echo->epw_m, 2.0 * (stretches[0].fall_m - stretches[0].rise_m), 8e-6);
    EXPECT_NEAR(echo->peak_w, stretches[0].peak_w, 1e-9 * power);
  }
}

// The same bits one by one: what a neighbour is must not matter, nor how wide the processor's vectors are.
TEST(LonePulses, ManyAtOnceAreEachAsIfAlone) {
  const ChainSettings settings = settingsWith(RangeMode::kLeadingEdge);
  LonePulses lone = manyPulses(0.1);
  const core::Random::Key frame{.seed = 9, .frame = 3};
  lone.fire(settings, frame, std::vector<double>(lone.size(), 1.1));
  for (std::uint32_t i = 0; i < lone.size(); ++i) {
    BeamNoise of_beam;
    of_beam.begin({.seed = 9, .frame = 1, .beam = i}, 4);
    const ShotNoise noise = of_beam.of(frame.frame, 0);
    Receiver receiver = settings.receiver;
    receiver.noise_w = noiseOf_w(i, 0.1);
    const auto echo = loneEcho({10.0 + i, 0.5 * std::pow(1.6, i)}, receiver, settings, 1.1, noise);
    ASSERT_EQ(echo.has_value(), lone.detected(i));
    if (!echo) continue;
    EXPECT_EQ(echo->range_m, lone.echo(i).range_m);
    EXPECT_EQ(echo->epw_m, lone.echo(i).epw_m);
    EXPECT_EQ(echo->peak_w, lone.echo(i).peak_w);
    EXPECT_EQ(noise.range, lone.noise(i).range);
  }
}

}  // namespace
}  // namespace model
