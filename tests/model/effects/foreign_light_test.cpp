#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "tests/model/effects/shot_bench.h"

namespace model {
namespace {

using nlohmann::json;

constexpr double kRadPerDeg = std::numbers::pi / 180.0;
const double kCatch_m2 = 0.5 * std::numbers::pi * 0.01 * 0.01;  ///< η A_r of the bench

/// Beams at -10, 0 and 10 degrees of azimuth, a board in front of the middle one.
lab::Case fan(const std::string& effect, json parameters) {
  lab::Case setup = lab::boardWith(20, effect, std::move(parameters));
  setup.scene[0]["shape"]["width_m"] = 3;
  setup.sensor["scan"]["layers"][0]["azimuth_deg"] = {{"from", -10}, {"to", 10}, {"step", 10}};
  return setup;
}

/// 2 hν P B with h and c of the SI and B = 0.44 / FWHM.
double shotNoise_w2(double power_w) {
  return 2.0 * 6.62607015e-34 * 299792458.0 / 905e-9 * power_w * 0.44 / (lab::kFwhm_ns * 1e-9);
}

TEST(Spoofing, SetsAFalseTargetIntoItsSectorOnly) {
  const core::Detections detections =
      lab::fire(fan("spoofing", {{"azimuth_deg", 10}, {"range_m", 33}, {"width_deg", 4}, {"power_w", 5e-7}}));
  ASSERT_EQ(detections.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const bool spoofed = detections.azimuth_rad[i] > 0.1;
    EXPECT_NEAR(detections.range_m[i], spoofed ? 33.0 : 20.0, 1e-4);
    if (spoofed) {
      EXPECT_NEAR(detections.intensity[i], 500.0, 0.01);
    }
  }
}

TEST(Spoofing, SectorGoesOnAcrossTheBack) {
  lab::Case setup = fan("spoofing", {{"azimuth_deg", -179}, {"range_m", 33}, {"width_deg", 4}});
  setup.sensor["scan"]["layers"][0]["azimuth_deg"] = {{"from", 179}, {"to", 179}, {"step", 1}};
  EXPECT_EQ(lab::fire(setup).size(), 1u);
}

TEST(Blinding, ForeignLightAddsItsShotNoiseInTheSector) {
  lab::Case setup = fan("blinding", {{"azimuth_deg", 0}, {"irradiance", 0.01}, {"width_deg", 4}});
  setup.sensor["receiver"]["noise_w"] = 2e-9;
  const lab::ShotBench bench(setup);
  const double expected_w = std::sqrt(4e-18 + shotNoise_w2(0.01 * kCatch_m2));
  EXPECT_NEAR(bench.shot(0, 1).receiver.noise_w / expected_w, 1.0, 1e-6);
  EXPECT_EQ(bench.shot(0, 0).receiver.noise_w, 2e-9);
  EXPECT_EQ(bench.shot(0, 2).receiver.noise_w, 2e-9);
}

TEST(Blinding, TakesTheRangeBelowSaturation) {
  lab::Case setup = fan("blinding", {{"irradiance", 2.5}, {"saturation_irradiance", 10}});
  setup.sensor["receiver"]["saturation_w"] = 4e-6;
  EXPECT_NEAR(*lab::ShotBench(setup).shot(0, 1).receiver.saturation_w, 3e-6, 1e-18);
}

TEST(Blinding, AGainThatGivesWayLeavesWeakerEchoesInTheSectorOnly) {
  lab::Case setup = fan("blinding", {{"irradiance", 0.01}, {"width_deg", 4}});
  setup.scene[0]["shape"]["width_m"] = 20;  // before all three beams
  const lab::ShotBench clear(setup);
  setup.effects["blinding"]["gain_loss"] = 0.6;
  const lab::ShotBench bench(setup);
  EXPECT_NEAR(bench.shot(0, 1).pulses.at(0).power_w / clear.shot(0, 1).pulses.at(0).power_w, 0.4, 1e-9);
  EXPECT_EQ(bench.shot(0, 0).pulses.at(0).power_w, clear.shot(0, 0).pulses.at(0).power_w);
}

TEST(Blinding, FromSaturationOnNothingIsSeen) {
  lab::Case setup = fan("blinding", {{"irradiance", 10}, {"saturation_irradiance", 10}});
  setup.frames = 50;
  EXPECT_EQ(lab::fire(setup).size(), 0u);
  const ShotRecord shot = lab::ShotBench(setup).shot(0, 1);
  ASSERT_EQ(shot.echoes.size(), 1u);
  EXPECT_EQ(shot.echoes[0].fate, Fate::kBlinded);
  setup.effects["blinding"]["azimuth_deg"] = 10;
  EXPECT_EQ(lab::fire(setup).size(), 50u);
}

json sun(double azimuth_deg, double elevation_deg) {
  return {{"irradiance_w_m2_nm", 0.5}, {"sun_azimuth_deg", azimuth_deg}, {"sun_elevation_deg", elevation_deg}};
}

double noise2(const json& parameters) {
  return std::pow(lab::ShotBench(lab::boardWith(20, "background-light", parameters)).shot().receiver.noise_w, 2);
}

/// Henyey–Greenstein with g = 0.7 and an optical depth of 0.1, times the solid angle of 3 mrad × 3 mrad.
double aureole(double angle_rad) {
  return 9e-6 * 0.1 / (4 * std::numbers::pi) * 0.51 / std::pow(1.49 - 1.4 * std::cos(angle_rad), 1.5);
}

/// Noise of a sensor that has none of its own, before a board of this reflectivity across all of a beam. [W²]
double noise2Before(double reflectivity) {
  lab::Case setup = lab::boardWith(20, "background-light", {{"irradiance_w_m2_nm", 0.5}});
  setup.sensor["receiver"]["noise_w"] = 0.0;
  setup.materials["grey"]["reflectivity"] = reflectivity;
  return std::pow(lab::ShotBench(setup).shot().receiver.noise_w, 2);
}

// P_b = E Δλ ρ/π A_r Ω η with 20 nm, and 3 mrad × 3 mrad in view.
TEST(BackgroundLight, ASurfaceSendsAsMuchLightAsItIsBright) {
  for (const double reflectivity : {0.1, 0.4, 0.9}) {
    const double light_w = 0.5 * 20.0 * reflectivity / std::numbers::pi * 9e-6 * kCatch_m2;
    EXPECT_NEAR(noise2Before(reflectivity) / shotNoise_w2(light_w), 1.0, 1e-6) << reflectivity;
  }
}

// The outer beams of the fan see the sky, which is as bright as a surface that throws back a tenth.
TEST(BackgroundLight, TheSkyIsDarkerThanTheGround) {
  lab::Case setup = fan("background-light", {{"irradiance_w_m2_nm", 0.5}});
  setup.sensor["receiver"]["noise_w"] = 0.0;
  const lab::ShotBench bench(setup);
  EXPECT_NEAR(std::pow(bench.shot(0, 0).receiver.noise_w, 2) / noise2Before(0.1), 1.0, 1e-6);
}

// The sun has a radius of 4.65 mrad; a field of view of 3 mrad × 3 mrad sees 9e-6 sr of it, or nothing.
TEST(BackgroundLight, SunDazzlesTheBeamsThatLookAtIt) {
  const double scene = noise2({{"irradiance_w_m2_nm", 0.5}});
  const double direct = shotNoise_w2(0.5 * 20.0 * kCatch_m2);
  const double share = 9e-6 / (std::numbers::pi * 0.00465 * 0.00465);
  EXPECT_NEAR((noise2(sun(0, 0.05)) - scene) / direct / (share + aureole(0.05 * kRadPerDeg)), 1.0, 1e-6);
  for (const double angle_deg : {2.0, 20.0, 80.0}) {
    EXPECT_NEAR((noise2(sun(0, angle_deg)) - scene) / direct / aureole(angle_deg * kRadPerDeg), 1.0, 1e-3);
  }
}

TEST(BackgroundLight, SunBelowTheHorizonOrOfNoKnownHeightChangesNothing) {
  const double scene = noise2({{"irradiance_w_m2_nm", 0.5}});
  EXPECT_EQ(noise2(sun(0, -1)), scene);
  EXPECT_EQ(noise2({{"irradiance_w_m2_nm", 0.5}, {"sun_azimuth_deg", 0}}), scene);
}

}  // namespace
}  // namespace model
