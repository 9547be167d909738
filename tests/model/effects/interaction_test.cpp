// Effects of the interaction with surfaces: pulse broadening is held by signal_chain_test.cpp.
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <utility>

#include "model/signal/waveform.h"
#include "tests/model/effects/effect_bench.h"

namespace model {
namespace {

using nlohmann::json;

double radians(double deg) { return deg * std::numbers::pi / 180; }

double factor(double incidence_deg, const std::string& effect, const json& parameters, const json& brdf = nullptr) {
  lab::Case with = lab::slanted(lab::boardWith(10, effect, parameters), incidence_deg);
  lab::Case without = lab::slanted(lab::boardWith(10), incidence_deg);
  if (!brdf.is_null()) with.materials["grey"]["brdf"] = without.materials["grey"]["brdf"] = brdf;
  return lab::power_w(with) / lab::power_w(without);
}

TEST(AngularReflection, OrenNayarHasThePublishedFactors) {
  const double s = 0.35 * 0.35, a = 1 - 0.5 * s / (s + 0.33), b = 0.45 * s / (s + 0.09);
  for (const double incidence : {0.0, 30.0, 60.0}) {
    const double expected = a + b * std::sin(radians(incidence)) * std::tan(radians(incidence));
    EXPECT_NEAR(factor(incidence, "angular-reflection", {{"model", "oren-nayar"}, {"roughness_rad", 0.35}}), expected,
                1e-5);
    EXPECT_NEAR(
        factor(incidence, "angular-reflection", json::object(), {{"model", "oren-nayar"}, {"roughness_rad", 0.35}}),
        expected, 1e-5);
  }
  EXPECT_NEAR(factor(40, "angular-reflection", {{"roughness_rad", 0.0}}), 1.0, 1e-9);  // smooth is Lambertian
}

TEST(AngularReflection, PhongHasItsLobeAroundTheMirrorDirection) {
  for (const double incidence : {0.0, 10.0, 30.0, 60.0}) {
    const double lobe = std::pow(std::max(0.0, std::cos(radians(2 * incidence))), 20.0) * 22.0 / 2.0;
    EXPECT_NEAR(factor(incidence, "angular-reflection", {{"diffuse_fraction", 0.8}, {"exponent", 20}}),
                0.8 + 0.2 * lobe, 1e-5);
  }
}

// Off: a material's BRDF is as if it were Lambertian (formats.md section 1).
TEST(AngularReflection, OffLeavesLambertianSurfaces) {
  lab::Case setup = lab::slanted(lab::boardWith(10), 50);
  setup.materials["grey"]["brdf"] = {{"model", "phong"}, {"diffuse_fraction", 0.1}, {"exponent", 50}};
  EXPECT_NEAR(lab::power_w(setup) / lab::radarEquation(10, 0.5, std::cos(radians(50))), 1.0, 1e-6);
}

TEST(Retroreflection, SurplusHalvesAtTheHalfWidth) {
  const json beads = {{"model", "retroreflector"}, {"gain", 300}, {"half_width_rad", 0.5}};
  EXPECT_NEAR(factor(0, "retroreflection", json::object(), beads), 300, 1e-3);
  EXPECT_NEAR(factor(0.5 * 180 / std::numbers::pi, "retroreflection", json::object(), beads), 1 + 299 / 2.0, 1e-2);
  EXPECT_NEAR(factor(0, "retroreflection", {{"gain", 1000}}, beads), 1000, 1e-3);
  EXPECT_NEAR(factor(0, "retroreflection", {{"gain", 1000}}), 1.0, 1e-12);  // other materials stay
}

// Diffuse part (1 - F)(1 - p)/(1 - p A) with p = 0.472, F = 0.02; the lobe F (n+2)/2 / A at normal incidence only.
TEST(SurfaceMoisture, WetIsDarkerAndShinesAtNormalIncidence) {
  const double diffuse = 0.98 * 0.528 / (1 - 0.472 * 0.5);
  EXPECT_NEAR(factor(45, "surface-moisture", {{"wetness", 1.0}}), diffuse, 1e-6);
  EXPECT_NEAR(factor(45, "surface-moisture", {{"wetness", 0.5}}), 0.5 + 0.5 * diffuse, 1e-6);
  EXPECT_NEAR(factor(0, "surface-moisture", {{"wetness", 1.0}}), diffuse + 0.02 * 51 / 0.5, 1e-5);
  EXPECT_NEAR(factor(45, "surface-moisture", {{"wetness", 0.0}}), 1.0, 1e-12);
}

// Gamma: mean 1, variance 1/M. The variance of a sample variance is (μ4 - σ⁴)/n with μ4 = 3 σ⁴ (1 + 2/M).
TEST(Speckle, FluctuationHasMeanOneAndVarianceOneOverLooks) {
  const int n = 40000;
  for (const double looks : {4.0, 25.0}) {
    lab::Case setup = lab::boardWith(5, "speckle", {{"looks", looks}});
    setup.frames = n;
    const auto intensity = lab::fire(setup).intensity;
    ASSERT_EQ(intensity.size(), static_cast<std::size_t>(n));
    const double mean = 1e9 * lab::radarEquation(5);
    EXPECT_NEAR(lab::mean(intensity) / mean, 1.0, 4 / std::sqrt(looks * n));
    const double variance = std::pow(lab::deviation(intensity) / mean, 2);
    EXPECT_NEAR(variance * looks, 1.0, 4 * std::sqrt((2 + 6 / looks) / n));
  }
}

struct Glitter {
  double near_share, board_share;  ///< standard deviation over mean of the intensities
};

/// A board behind the near echo of a fog, both far above the threshold.
lab::Case boardInFog(double visibility_m, double board_m, const std::string& effect = "", const json& parameters = {}) {
  lab::Case setup = lab::boardWith(board_m, effect, parameters);
  setup.sensor["detection"]["min_range_m"] = 2.0;
  setup.effects["atmospheric-backscatter"] = {{"visibility_m", visibility_m}};
  setup.frames = 2000;
  return setup;
}

Glitter glitterOf(const lab::Case& setup) {
  const core::Detections detections = lab::fire(setup);
  std::vector<double> near, board;
  for (std::size_t i = 0; i < detections.size(); ++i) {
    (detections.range_m[i] < 9.0 ? near : board).push_back(detections.intensity[i]);
  }
  EXPECT_EQ(near.size(), 2000U);
  EXPECT_EQ(board.size(), 2000U);
  return {lab::deviation(near) / lab::mean(near), lab::deviation(board) / lab::mean(board)};
}

/// How many parts a waveform has at the lowest level that anybody asks for.
std::size_t partsOfWaveform(const lab::Case& setup) {
  std::vector<Pulse> pulses = lab::pulses(setup);
  return partsOf(pulses, {0.299792458 * lab::kFwhm_ns / 2.0, {}}, 2e-10).size();
}

// What droplets send back comes from a depth of pulse lengths: it does not glitter, whether its waveform reaches to the
// board's or not; a jitter of the emitted power is in both.
TEST(Speckle, LeavesTheEchoOfFogAsItIs) {
  ASSERT_EQ(partsOfWaveform(boardInFog(50.0, 18.0)), 1U);
  ASSERT_EQ(partsOfWaveform(boardInFog(3000.0, 90.0)), 2U);
  for (const auto& [visibility_m, board_m] : {std::pair(50.0, 18.0), std::pair(3000.0, 90.0)}) {
    const Glitter glitter = glitterOf(boardInFog(visibility_m, board_m, "speckle", {{"looks", 25.0}}));
    EXPECT_LT(glitter.near_share, 1e-3) << visibility_m;
    EXPECT_NEAR(glitter.board_share, 0.2, 0.02) << visibility_m;
  }
  const Glitter jitter = glitterOf(boardInFog(50.0, 25.0, "pulse-jitter", {{"power_stddev", 0.2}}));
  EXPECT_NEAR(jitter.near_share, 0.2, 0.02);
  EXPECT_NEAR(jitter.board_share, 0.2, 0.02);
}

// The copy of a pulse that somebody sends comes from no surface.
TEST(Speckle, LeavesAFalseTargetAsItIs) {
  lab::Case setup = lab::boardWith(5, "speckle", {{"looks", 25.0}});
  setup.scene.clear();
  setup.effects["spoofing"] = {{"azimuth_deg", 0.0}, {"range_m", 15.0}, {"power_w", 1e-6}};
  setup.frames = 200;
  const std::vector<double> intensity = lab::fire(setup).intensity;
  ASSERT_EQ(intensity.size(), 200U);
  EXPECT_NEAR(lab::deviation(intensity), 0.0, 1e-9);
}

}  // namespace
}  // namespace model
