#include "model/signal/waveform.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace model {
namespace {

constexpr double kFwhm_m = 0.75;

double signalAt(const std::vector<Pulse>& pulses, double range_m) {
  double sum = 0.0;
  for (const Pulse& pulse : pulses) {
    const double u = (range_m - pulse.range_m) / kFwhm_m;
    sum += pulse.power_w * std::exp2(-4.0 * u * u);
  }
  return sum;
}

/// Independent and slow: in steps of a fiftieth of a millimetre, if no others are asked for.
std::vector<Stretch> bruteForce(const std::vector<Pulse>& pulses, double level_w, double from_m, double to_m,
                                double step_m = 2e-5) {
  std::vector<Stretch> stretches;
  bool above = false;
  for (double r = from_m; r < to_m; r += step_m) {
    const double s = signalAt(pulses, r);
    if (s > level_w && !above) stretches.push_back({.rise_m = r});
    above = s > level_w;
    if (!above) continue;
    Stretch& stretch = stretches.back();
    stretch.fall_m = r;
    if (s > stretch.peak_w) {
      stretch.peak_w = s;
      stretch.peak_m = r;
    }
  }
  return stretches;
}

std::vector<Stretch> stretchesOf(std::vector<Pulse> pulses, double level_w, double lowest_w, double fwhm_m = kFwhm_m) {
  std::vector<Stretch> stretches;
  for (const WaveformPart& part : partsOf(pulses, {fwhm_m, {}}, lowest_w)) part.stretchesAbove(level_w, stretches);
  return stretches;
}

void expectNear(const std::vector<Stretch>& got, const std::vector<Stretch>& expected, double within_m,
                double of_peak) {
  ASSERT_EQ(got.size(), expected.size());
  for (std::size_t i = 0; i < got.size(); ++i) {
    EXPECT_NEAR(got[i].rise_m, expected[i].rise_m, within_m);
    EXPECT_NEAR(got[i].fall_m, expected[i].fall_m, within_m);
    EXPECT_NEAR(got[i].peak_w / expected[i].peak_w, 1.0, of_peak);
  }
}

// g falls to P_th/P at ± FWHM/2 · sqrt(log2(P/P_th)).
TEST(Waveform, WidthOfOnePulseIsTheClosedForm) {
  for (const double ratio : {1.0001, 1.01, 1.5, 2.0, 16.0, 1e4, 1e8}) {
    const auto stretches = stretchesOf({{42.0, ratio}}, 1.0, 0.1);
    ASSERT_EQ(stretches.size(), 1u) << ratio;
    const double half = kFwhm_m / 2.0 * std::sqrt(std::log2(ratio));
    EXPECT_NEAR(stretches[0].rise_m, 42.0 - half, 2e-6) << ratio;
    EXPECT_NEAR(stretches[0].fall_m, 42.0 + half, 2e-6) << ratio;
    EXPECT_NEAR(stretches[0].peak_m, 42.0, 1e-6) << ratio;
    EXPECT_NEAR(stretches[0].peak_w / ratio, 1.0, 1e-9) << ratio;
  }
}

TEST(Waveform, BelowTheLevelThereIsNothing) {
  EXPECT_TRUE(stretchesOf({{42.0, 0.999}}, 1.0, 0.1).empty());
  EXPECT_TRUE(stretchesOf({}, 1.0, 0.1).empty());
  EXPECT_TRUE(stretchesOf({{42.0, 0.0}}, 1.0, 0.1).empty());
}

// Sums are no single Gaussian, so what is drawn through samples errs: below a millimetre of range and a ten thousandth
// of the power even where the level just touches a saddle.
TEST(Waveform, SumsOfPulsesAgreeWithSlowSampling) {
  const std::vector<std::vector<Pulse>> scenes = {
      {{10.0, 5.0}, {10.4, 3.0}},                             // one hump
      {{10.0, 5.0}, {11.3, 3.0}},                             // two humps that stay connected at low levels
      {{10.0, 50.0}, {11.0, 4.0}},                            // a shoulder
      {{10.0, 1.2}, {10.5, 0.7}, {11.1, 2.0}, {14.0, 0.9}},   // the last one alone stays below
      {{10.0, 0.6}, {10.1, 0.6}, {12.4, 300.0}, {13.9, 2.0}}  // the sum is above, no single pulse
  };
  for (const auto& pulses : scenes) {
    for (const double level_w : {0.3, 1.0, 2.5}) {
      const auto expected = bruteForce(pulses, level_w, 5.0, 20.0);
      const auto got = stretchesOf(pulses, level_w, 0.1);
      ASSERT_EQ(got.size(), expected.size()) << pulses.size() << " pulses, level " << level_w;
      for (std::size_t i = 0; i < got.size(); ++i) {
        EXPECT_NEAR(got[i].rise_m, expected[i].rise_m, 1e-3);
        EXPECT_NEAR(got[i].fall_m, expected[i].fall_m, 1e-3);
        EXPECT_NEAR(got[i].peak_w / expected[i].peak_w, 1.0, 1e-4);
        EXPECT_NEAR(got[i].peak_m, expected[i].peak_m, 5e-4);
      }
    }
  }
}

// Against the difference of two waveforms, of pulses 0.2 % longer and shorter.
TEST(Waveform, SaysWhatALongerPulseDoesToEdgesAndPeak) {
  const std::vector<std::vector<Pulse>> scenes = {{{10.0, 20.0}},
                                                  {{10.0, 20.0}, {10.3, 12.0}},
                                                  {{10.0, 5.0}, {10.9, 3.0}},
                                                  {{10.0, 9.0}, {10.2, 9.0}, {10.4, 9.0}, {10.6, 9.0}, {10.8, 9.0}}};
  for (const auto& pulses : scenes) {
    const auto got = stretchesOf(pulses, 1.0, 0.1);
    const auto longer = stretchesOf(pulses, 1.0, 0.1, 1.002 * kFwhm_m);
    const auto shorter = stretchesOf(pulses, 1.0, 0.1, 0.998 * kFwhm_m);
    ASSERT_EQ(got.size(), 1u);
    const auto slope = [&](double Stretch::*of) { return (longer.at(0).*of - shorter.at(0).*of) / 0.004; };
    EXPECT_NEAR(got[0].rise_per_width_m, slope(&Stretch::rise_m), 0.02 * kFwhm_m) << pulses.size();
    EXPECT_NEAR(got[0].fall_per_width_m, slope(&Stretch::fall_m), 0.02 * kFwhm_m) << pulses.size();
    EXPECT_NEAR(got[0].peak_per_width, slope(&Stretch::peak_w) / got[0].peak_w, 0.01) << pulses.size();
  }
}

// A linear ramp of pulses of total power P over a length L is a convolution with a box; its peak is P/L · ∫ g over L.
TEST(Waveform, SpreadPulsesKeepTheirEnergy) {
  const double length = 2.0, power = 100.0;
  std::vector<Pulse> pulses;
  const int n = 400;
  for (int i = 0; i < n; ++i) pulses.push_back({20.0 + length * ((i + 0.5) / n - 0.5), power / n});
  const auto stretches = stretchesOf(pulses, 1.0, 0.1);
  ASSERT_EQ(stretches.size(), 1u);
  const double sigma = kFwhm_m / (2.0 * std::sqrt(2.0 * std::log(2.0)));
  const double integral = sigma * std::sqrt(2.0 * M_PI) * std::erf(length / 2.0 / sigma / std::sqrt(2.0));
  EXPECT_NEAR(stretches[0].peak_w, power / length * integral, 1e-4 * power);
}

TEST(Waveform, PartsThatDoNotTouchAreSeparate) {
  std::vector<Pulse> far_apart = {{10.0, 5.0}, {60.0, 5.0}};
  EXPECT_EQ(partsOf(far_apart, {kFwhm_m, {}}, 0.1).size(), 2u);
  std::vector<Pulse> near = {{10.0, 5.0}, {10.5, 5.0}};
  EXPECT_EQ(partsOf(near, {kFwhm_m, {}}, 0.1).size(), 1u);
  std::vector<Pulse> weak = {{10.0, 5.0}, {60.0, 0.09}};
  EXPECT_EQ(partsOf(weak, {kFwhm_m, {}}, 0.1).size(), 1u);
}

// Sums at random. Where the level touches a saddle, a crossing may be farther off: one in fifty.
TEST(Waveform, CrossingsAndPeaksOfSumsAreGoodToAThousandthOfTheWidth) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(10.0, 10.0 + 2.5 * kFwhm_m), decades(-1.5, 0.0), level(0.05, 0.6);
  int compared = 0, wide = 0;
  for (int trial = 0; trial < 60; ++trial) {
    std::vector<Pulse> pulses;
    for (int k = 2 + trial % 6; k > 0; --k) pulses.push_back({place(random), std::pow(10.0, decades(random))});
    const double level_w = level(random);
    const auto expected = bruteForce(pulses, level_w, 5.0, 20.0), got = stretchesOf(pulses, level_w, 0.04);
    ASSERT_EQ(got.size(), expected.size()) << trial;
    for (std::size_t i = 0; i < got.size(); ++i, ++compared) {
      const double edge_m =
          std::max(std::abs(got[i].rise_m - expected[i].rise_m), std::abs(got[i].fall_m - expected[i].fall_m));
      wide += edge_m > 5e-4 * kFwhm_m || std::abs(got[i].peak_m - expected[i].peak_m) > 1e-3 * kFwhm_m ? 1 : 0;
      EXPECT_NEAR(got[i].peak_w / expected[i].peak_w, 1.0, 2.5e-4) << trial;
    }
  }
  EXPECT_GT(compared, 50);
  EXPECT_LE(wide, compared / 50);
}

/// What a thin fog throws back, and a board in it that is hardly above the threshold.
std::vector<Pulse> fogAndBoard() {
  std::vector<Pulse> pulses;
  for (double range_m = 0.5; range_m < 60.0; range_m += kFwhm_m / 2.0)
    pulses.push_back({range_m, 10.0 / (range_m * range_m)});
  pulses.push_back({40.2, 1.3});
  return pulses;
}

// The fog is above the lowest level for the first ten metres only, and what is farther needs no samples; where the
// board is, it still adds its share.
TEST(Waveform, SilentTailOfAFogIsNoPartButReachesIntoOthers) {
  std::vector<Pulse> pulses = fogAndBoard();
  EXPECT_EQ(partsOf(pulses, {kFwhm_m, {}}, 0.1).size(), 2U);
  for (const double level_w : {0.1001, 0.3, 1.0}) {
    const auto expected = bruteForce(fogAndBoard(), level_w, -5.0, 70.0, 1e-4),
               got = stretchesOf(fogAndBoard(), level_w, 0.1);
    SCOPED_TRACE(level_w);
    expectNear(got, expected, 1e-3, 2.5e-3);
  }
}

// A fog sends its share as ever while the board in front of its tail glitters; the slow sampling adds the same pulses
// with the powers that they then have.
TEST(Waveform, SurfacesOfAMixedPartFluctuateAlone) {
  std::vector<Pulse> pulses;
  for (double range_m = 2.0; range_m < 6.0; range_m += kFwhm_m / 2.0) pulses.push_back({range_m, 2.0, false});
  pulses.push_back({6.2, 3.0});
  pulses.push_back({7.0, 1.0});
  for (const double gain : {0.0, 0.4, 1.0, 2.5}) {
    std::vector<Pulse> fluctuating = pulses, unchanged = pulses;
    for (Pulse& pulse : fluctuating) pulse.power_w *= pulse.of_surface ? gain : 1.0;
    const std::vector<WaveformPart> parts = partsOf(unchanged, {kFwhm_m, {}}, 0.01);
    ASSERT_EQ(parts.size(), 1U);
    ASSERT_TRUE(parts[0].mixed());
    std::vector<Stretch> got;
    parts[0].withSurfacesAt(gain).stretchesAbove(1.0, got);
    const auto expected = bruteForce(fluctuating, 1.0, 0.0, 10.0, 1e-4);
    SCOPED_TRACE(gain);
    expectNear(got, expected, 1e-3, 2.5e-3);
  }
}

TEST(Waveform, PartKnowsWhetherSurfacesSentIt) {
  std::vector<Pulse> pulses = {{10.0, 1.0, false}, {10.3, 1.0, false}, {30.0, 1.0, true}, {50.0, 1.0, false}};
  const std::vector<WaveformPart> parts = partsOf(pulses, {kFwhm_m, {}}, 0.1);
  ASSERT_EQ(parts.size(), 3U);
  const auto of_surface = [&](std::size_t part) { return parts[part].ofSurface(); };
  EXPECT_EQ((std::vector{of_surface(0), of_surface(1), of_surface(2)}), (std::vector{false, true, false}));
  for (const WaveformPart& part : parts) EXPECT_FALSE(part.mixed());
}

/// A form that was measured: a triangle, one width wide at half its height.
PulseForm triangle() { return {kFwhm_m, PulseShape({-1.0, 0.0, 1.0}, {0.0, 1.0, 0.0})}; }

// Of a measured form, too: as pulses that are so strong from the beginning, which are sampled elsewhere.
TEST(Waveform, SurfacesOfAMixedPartFluctuateInAnyForm) {
  std::vector<Pulse> pulses = {{2.0, 2.0, false}, {2.5, 3.0, true}},
                     fluctuating = {{2.0, 2.0, false}, {2.5, 1.2, true}};
  const auto mixed = partsOf(pulses, triangle(), 0.01), expected = partsOf(fluctuating, triangle(), 0.01);
  ASSERT_EQ(mixed.size(), 1U);
  std::vector<Stretch> got, right;
  mixed[0].withSurfacesAt(0.4).stretchesAbove(1.0, got);
  expected[0].stretchesAbove(1.0, right);
  ASSERT_FALSE(got.empty());
  expectNear(got, right, 1e-4, 1e-3);
}

// A triangle of full width w at half maximum is 2 w (1 - q) wide at the share q of its height.
TEST(Waveform, MeasuredPulseHasTheWidthOfItsOwnForm) {
  for (const double ratio : {1.25, 2.0, 10.0}) {
    std::vector<Pulse> one{{42.0, ratio}};
    std::vector<Stretch> stretches;
    for (const WaveformPart& part : partsOf(one, triangle(), 0.1)) part.stretchesAbove(1.0, stretches);
    ASSERT_EQ(stretches.size(), 1u);
    EXPECT_NEAR(stretches[0].fall_m - stretches[0].rise_m, 2.0 * kFwhm_m * (1.0 - 1.0 / ratio), 1e-12);
    EXPECT_EQ(stretches[0].peak_w, ratio);
  }
}

// Two equal triangles half a base apart sum up to a trapezium with a flat roof: base 2 w + d, height P.
TEST(Waveform, MeasuredPulsesAddUp) {
  std::vector<Pulse> two{{42.0, 4.0}, {42.0 + kFwhm_m, 4.0}};
  std::vector<Stretch> stretches;
  for (const WaveformPart& part : partsOf(two, triangle(), 0.1)) part.stretchesAbove(1.0, stretches);
  ASSERT_EQ(stretches.size(), 1u);
  const double step_m = kFwhm_m / 16.0;  // of the samples, between which log s is a parabola and not a line
  EXPECT_NEAR(stretches[0].rise_m, 42.0 - 0.75 * kFwhm_m, 0.05 * step_m);
  EXPECT_NEAR(stretches[0].fall_m, 42.0 + 1.75 * kFwhm_m, 0.05 * step_m);
  EXPECT_NEAR(stretches[0].peak_w, 4.0, 0.01 * 4.0);  // the parabola overshoots the corner of the roof
}

}  // namespace
}  // namespace model
