#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "tests/model/effects/shot_bench.h"

namespace model {
namespace {

using nlohmann::json;

constexpr double kWidth_m = 0.299792458 * lab::kFwhm_ns / 2.0;
constexpr double kNearest_m = 2.0;

/// Received power of a Lambertian mirror of reflectivity π at 1 m: η A_r P_t. [W m²]
double constant_w_m2() { return lab::radarEquation(1.0, std::numbers::pi); }

lab::Case fog(json parameters) {
  lab::Case setup;
  setup.sensor["detection"]["min_range_m"] = kNearest_m;
  setup.effects["atmospheric-backscatter"] = std::move(parameters);
  return setup;
}

// Below 500 m of visibility Kim's exponent is 0, so α = 3.912 / V at any wavelength.
struct Air {
  double extinction_1_m = 3.912 / 50.0;
  double backscatter_1_m_sr = extinction_1_m / 18.8;
  [[nodiscard]] double power_w_m(double range_m) const {
    return constant_w_m2() * backscatter_1_m_sr * std::exp(-2.0 * extinction_1_m * range_m) / (range_m * range_m);
  }
};

/// The pulse of unit peak, so far from it.
double pulseAt(double from_peak_m) { return std::exp(-4.0 * std::numbers::ln2 * std::pow(from_peak_m / kWidth_m, 2)); }

// The waveform of fog is the convolution of the lidar equation with the pulse; here by Simpson's rule at the places
// where the comb's waveform falls through three levels. A cell of half a pulse loses (w/2)²/24 of the curvature, and
// that of exp(-2 α r) / r² is (6/r² + 8 α/r + 4 α²).
TEST(AtmosphericBackscatter, WaveformIsTheConvolutionOfLidarEquationAndPulse) {
  std::vector<Pulse> pulses = lab::pulses(fog({{"visibility_m", 50}}));
  const std::vector<WaveformPart> parts = partsOf(pulses, {kWidth_m, {}}, 1e-9);
  ASSERT_EQ(parts.size(), 1u);
  for (const double level_w : {1e-6, 2e-7, 2e-8}) {
    std::vector<Stretch> stretches;
    parts[0].stretchesAbove(level_w, stretches);
    ASSERT_EQ(stretches.size(), 1u);
    const double at_m = stretches[0].fall_m;
    const auto integrand = [&](double r) { return Air{}.power_w_m(r) * pulseAt(at_m - r); };
    const double a = Air{}.extinction_1_m, curvature = 6.0 / (at_m * at_m) + 8.0 * a / at_m + 4.0 * a * a;
    EXPECT_NEAR(lab::integral(kNearest_m, at_m + 6.0, integrand) / level_w, 1.0, kWidth_m * kWidth_m / 96 * curvature)
        << at_m;
  }
}

/// Where the only echo of a case rises and falls through half of its height, and how high it is, by a waveform.
template <typename Waveform_w>
void expectConvolution(const lab::Case& setup, Waveform_w waveform_w) {
  std::vector<Pulse> pulses = lab::pulses(setup);
  const std::vector<WaveformPart> parts = partsOf(pulses, {kWidth_m, {}}, 1e-9);
  ASSERT_EQ(parts.size(), 1u);
  const double level_w = 0.5 * parts[0].peak_w();
  std::vector<Stretch> stretches;
  parts[0].stretchesAbove(level_w, stretches);
  ASSERT_EQ(stretches.size(), 1u);
  EXPECT_NEAR(waveform_w(stretches[0].rise_m) / level_w, 1.0, 5e-3);
  EXPECT_NEAR(waveform_w(stretches[0].fall_m) / level_w, 1.0, 5e-3);
  EXPECT_NEAR(waveform_w(stretches[0].peak_m) / stretches[0].peak_w, 1.0, 5e-3);
}

// Half a metre from the sensor 1/r² falls by two thirds within half a pulse. Where the waveform rises and falls
// through a level, and how high it is, by Simpson's rule.
TEST(AtmosphericBackscatter, NearEchoIsTheConvolutionHalfAMetreAway) {
  lab::Case setup = fog({{"visibility_m", 50}});
  setup.sensor["detection"]["min_range_m"] = 0.5;
  expectConvolution(setup, [](double at_m) {
    return lab::integral(0.5, at_m + 6.0, [&](double r) { return Air{}.power_w_m(r) * pulseAt(at_m - r); });
  });
}

TEST(AtmosphericBackscatter, NearEchoStandsWhereTheReceiverBeginsToListen) {
  const core::Detections detections = lab::fire(fog({{"visibility_m", 50}}));
  ASSERT_EQ(detections.size(), 1u);
  EXPECT_GT(detections.range_m[0], kNearest_m);
  EXPECT_LT(detections.range_m[0], kNearest_m + kWidth_m);
}

// Midpoint rule of 0.37 m steps on 1/r² from 2 m on: better than 1 %.
TEST(AtmosphericBackscatter, EndsAtTheSurfaceThatTheBeamMeets) {
  lab::Case setup = fog({{"visibility_m", 50}});
  setup.scene = {lab::board(12.0)};
  double sum_w = 0.0;
  for (const Pulse& pulse : lab::pulses(setup)) {
    EXPECT_LE(pulse.range_m, 12.0 + kWidth_m / 4.0);
    if (pulse.range_m != 12.0) sum_w += pulse.power_w;
  }
  const double expected_w = lab::integral(kNearest_m, 12.0, [](double r) { return Air{}.power_w_m(r); });
  EXPECT_NEAR(sum_w / expected_w, 1.0, 0.01);
}

TEST(AtmosphericBackscatter, IsProportionalToTheBackscatterGiven) {
  const double own_w = lab::pulses(fog({{"visibility_m", 50}}))[0].power_w;
  const double given_w = lab::pulses(fog({{"visibility_m", 50}, {"backscatter_1_m_sr", 0.001}}))[0].power_w;
  EXPECT_NEAR(given_w / own_w, 0.001 / Air{}.backscatter_1_m_sr, 1e-9);
}

// Discs of radius 1.5 mrad · r and 10 mm + 1.5 mrad · r touch from 20 mm / 3 mrad on when their axes are 30 mm apart.
TEST(AtmosphericBackscatter, StaysDarkWhereEmitterAndReceiverDoNotOverlap) {
  lab::Case setup = fog({{"visibility_m", 50}});
  setup.sensor["receiver"]["axis_offset_m"] = 0.03;
  setup.sensor["receiver"]["field_of_view_rad"] = {{"horizontal", 0.003}, {"vertical", 0.003}};
  const std::vector<Pulse> pulses = lab::pulses(setup);
  ASSERT_FALSE(pulses.empty());
  EXPECT_GT(pulses[0].range_m, 0.02 / 0.003);
  EXPECT_LT(pulses[0].range_m, 0.02 / 0.003 + kWidth_m);
}

json cloud(double x_m, double y_m = 0.0) {
  return {{"extinction_1_m", 0.3}, {"size_m", 2.0}, {"centre", {x_m, y_m, 0.0}}, {"albedo", 0.5}};
}

double powerAt(double range_m, const lab::Case& setup) {
  double sum_w = 0.0;
  for (const Pulse& pulse : lab::pulses(setup)) sum_w += pulse.range_m == range_m ? pulse.power_w : 0.0;
  return sum_w;
}

TEST(ExhaustCloud, WeakensWhatLiesBehindByTheChord) {
  const double clear_w = powerAt(20, lab::boardWith(20));
  EXPECT_NEAR(powerAt(20, lab::boardWith(20, "exhaust-cloud", cloud(10))) / clear_w, std::exp(-2 * 0.3 * 2.0), 1e-9);
  const double chord_m = 2.0 * std::sqrt(1.0 - 0.6 * 0.6);
  EXPECT_NEAR(powerAt(20, lab::boardWith(20, "exhaust-cloud", cloud(10, 0.6))) / clear_w, std::exp(-2 * 0.3 * chord_m),
              1e-9);
  EXPECT_EQ(powerAt(20, lab::boardWith(20, "exhaust-cloud", cloud(10, 1.01))), clear_w);
  EXPECT_NEAR(powerAt(20, lab::boardWith(20, "exhaust-cloud", cloud(20))) / clear_w, std::exp(-2 * 0.3 * 1.0), 1e-9);
}

// Midpoint rule of six steps over 2 m.
TEST(ExhaustCloud, SendsBackTheScatteredShare) {
  lab::Case setup;
  setup.effects["exhaust-cloud"] = cloud(10);
  const double expected_w = lab::integral(9.0, 11.0, [](double r) {
    return constant_w_m2() * 0.5 * 0.3 / 18.8 * std::exp(-2.0 * 0.3 * (r - 9.0)) / (r * r);
  });
  EXPECT_NEAR(lab::power_w(setup) / expected_w, 1.0, 0.005);
  setup.effects["exhaust-cloud"]["albedo"] = 0.0;
  EXPECT_TRUE(lab::pulses(setup).empty());
}

// 0.7 m of air are as long as the pulse: its echo is lower and wider than one pulse of the same energy, by a sixth.
TEST(ExhaustCloud, EchoOfAShortOneIsTheConvolution) {
  lab::Case setup;
  setup.effects["exhaust-cloud"] = cloud(10);
  setup.effects["exhaust-cloud"]["size_m"] = 0.7;
  expectConvolution(setup, [](double at_m) {
    return lab::integral(9.65, 10.35, [&](double r) {
      const double in_a_slice = 0.5 * 0.3 / 18.8 * std::exp(-2.0 * 0.3 * (r - 9.65)) / (r * r);
      return constant_w_m2() * in_a_slice * pulseAt(at_m - r);
    });
  });
}

// Of a cloud whose far end is where the receiver begins to listen hardly anything is left, or nothing.
TEST(ExhaustCloud, MayEndWhereTheReceiverBeginsToListen) {
  lab::Case setup;
  setup.effects["exhaust-cloud"] = cloud(1.1);
  setup.effects["exhaust-cloud"]["size_m"] = 0.2;
  setup.sensor["detection"]["min_range_m"] = 1.2;
  for (const Pulse& pulse : lab::pulses(setup)) {
    EXPECT_NEAR(pulse.range_m, 1.2, 1e-9);
    EXPECT_LT(pulse.power_w, 1e-15);
  }
}

TEST(ExhaustCloud, RefusesACentreThatIsNoPoint) {
  lab::Case setup = lab::boardWith(20, "exhaust-cloud", {{"centre", {1.0, 2.0}}});
  EXPECT_NE(lab::refusal([&] { (void)lab::modelOf(setup); }).find("centre"), std::string::npos);
}

}  // namespace
}  // namespace model
