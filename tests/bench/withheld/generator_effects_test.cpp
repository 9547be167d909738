#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <numbers>

#include "bench/withheld/generator/air.h"
#include "bench/withheld/generator/echoes.h"
#include "bench/withheld/generator/reflection.h"
#include "tests/bench/withheld/small_world.h"

// Every effect of the second generator changes what is measured, and the ones with a closed form obey it.
namespace {

using nlohmann::json;
using namespace small_world;

json object(const std::string& id, const json& shape, const json& position, const std::string& material,
            double yaw_deg = 0) {
  return {{"id", id},
          {"shape", shape},
          {"pose", {{"position_m", position}, {"yaw_pitch_roll_deg", {yaw_deg, 0, 0}}}},
          {"velocity_m_s", {0, 0, 0}},
          {"material", material}};
}

// Something for every effect: pane, mirror, glossy and rough boards, a retroreflector, a fast vehicle, a far wall.
json richExperiment() {
  json package = experiment({60}, 3);
  package["environment"]["temperature_degC"] = 40;
  const auto phong = [](double reflectivity, double diffuse) {
    return json{{"reflectivity", reflectivity},
                {"brdf", {{"model", "phong"}, {"diffuse_fraction", diffuse}, {"exponent", 20}}}};
  };
  package["materials"]["gloss"] = phong(0.5, 0.4);
  package["materials"]["mirror"] = phong(0.9, 0.2);
  package["materials"]["glass"] = {{"reflectivity", 0.05}, {"transmission", 0.8}, {"refractive_index", 1.5}};
  package["materials"]["retro"] = {{"reflectivity", 0.5},
                                   {"brdf", {{"model", "retroreflector"}, {"gain", 300}, {"half_width_rad", 0.4}}}};
  const json board = {{"type", "rectangle"}, {"width_m", 0.8}, {"height_m", 3}};
  package["scene"].push_back(object("gloss", board, {20, 2.8, 0}, "gloss", 5));
  package["scene"].push_back(object("pane", board, {15, 1.2, 0}, "glass"));
  package["scene"].push_back(object("mirror", board, {12, -1.8, 0}, "mirror", 45));
  package["scene"].push_back(
      object("side", {{"type", "rectangle"}, {"width_m", 40}, {"height_m", 20}}, {12, -20, 0}, "board", 90));
  package["scene"].push_back(
      object("sign", {{"type", "rectangle"}, {"width_m", 0.3}, {"height_m", 0.3}}, {18, -0.3, 0.16}, "retro"));
  // thinner than the beam, 6 m before the wall: two echoes near each other
  package["scene"].push_back(
      object("pole", {{"type", "cylinder"}, {"radius_m", 0.03}, {"height_m", 6}}, {54, -5.667, 0}, "board"));
  json vehicle = object("vehicle", {{"type", "box"}, {"size_m", {2, 1, 1.5}}}, {30, 0.6, 0}, "board");
  vehicle["velocity_m_s"] = {20, 0, 0};
  package["scene"].push_back(vehicle);
  return package;
}

// The least that the library has of each effect that is clearly seen in the rich scene.
const std::map<std::string, json>& clearlySeen() {
  static const std::map<std::string, json> effects = {{"beam-divergence", {{"horizontal_rad", 0.01}}},
                                                      {"aperture-offset", {{"offset_m", 0.1}}},
                                                      {"stray-radiation", {{"fraction", 0.01}}},
                                                      {"mounting-error", {{"yaw_deg", 1}, {"position_m", {0.1, 0, 0}}}},
                                                      {"pulse-jitter", {{"duration_stddev_ns", 0.2}}},
                                                      {"atmospheric-attenuation", {{"visibility_m", 300}}},
                                                      {"atmospheric-backscatter", {{"visibility_m", 40}}},
                                                      {"precipitation-clutter", {{"rain_rate_mm_h", 50}}},
                                                      {"road-spray", {{"density", 5}, {"extinction_1_m", 0.5}}},
                                                      {"exhaust-cloud", {{"extinction_1_m", 1}}},
                                                      {"crosstalk", {{"rate_1_s", 3e5}}},
                                                      {"spoofing", {{"range_m", 8}, {"width_deg", 5}}},
                                                      {"blinding", {{"irradiance", 1}}},
                                                      {"angular-reflection", json::object()},
                                                      {"surface-moisture", {{"wetness", 0.8}}},
                                                      {"retroreflection", json::object()},
                                                      {"transmission", json::object()},
                                                      {"multipath", json::object()},
                                                      {"pulse-broadening", json::object()},
                                                      {"speckle", {{"looks", 10}}},
                                                      {"motion-scan", json::object()},
                                                      {"cover-contamination", {{"attenuation", 0.4}}},
                                                      {"photo-response-nonuniformity", {{"stddev", 0.3}}},
                                                      {"background-light", {{"irradiance_w_m2_nm", 1}}},
                                                      {"thermal-noise", json::object()},
                                                      {"saturation", {{"saturation_w", 1e-7}}},
                                                      {"blooming", {{"fraction", 0.1}}},
                                                      {"dead-time", {{"dead_time_ns", 100}}},
                                                      {"range-walk", json::object()},
                                                      {"dynamic-threshold", {{"factor", 20}}},
                                                      {"quantisation", {{"range_step_m", 0.5}}},
                                                      {"range-gating", {{"from_m", 25}}},
                                                      {"echo-merging", {{"separation_m", 10}}},
                                                      {"latency", {{"delay_s", 0.1}}},
                                                      {"clock-drift", {{"per_kelvin_ppm", 50}}},
                                                      {"range-offset", {{"offset_m", 0.1}}},
                                                      {"false-alarm", {{"rate_per_beam", 0.1}}},
                                                      {"detection-loss", {{"probability", 0.2}}},
                                                      {"x-range-ripple", {{"amplitude_m", 0.05}, {"period_m", 3}}},
                                                      {"x-facet-wobble", {{"amplitude_m", 0.05}}},
                                                      {"x-epw-temperature", {{"per_kelvin", 0.01}}},
                                                      {"x-layer-skew", {{"epw_per_layer_m", 0.05}}},
                                                      {"x-epw-compression", {{"knee_m", 1}, {"slope", 0.5}}},
                                                      {"x-dropout-stripes", {{"period_deg", 5}, {"width_deg", 1}}},
                                                      {"x-gain-ramp", {{"per_degree", 0.03}}},
                                                      {"x-range-scatter", {{"per_metre", 0.001}}},
                                                      {"x-warm-up", {{"range_m", 0.1}}},
                                                      {"x-layer-range", {{"amplitude_m", 0.05}}}};
  return effects;
}

TEST(WithheldGeneratorEffects, EachChangesWhatIsMeasured) {
  const auto tableOf = [](json effects) {
    effects.emplace("beam-divergence", json::object());
    json world = model(effects);
    world["sensor"]["receiver"]["noise_w"] = 2e-9;
    return generated(richExperiment(), world);
  };
  const Table baseline = tableOf(json::object());
  ASSERT_GT(baseline.at("range_m").size(), 200U);
  for (const auto& entry : withheld::allEffects()) {
    // always on in the reference chain; only with raised noise
    if (entry.name == "angle-clipping" || entry.name == "x-noise-echoes") continue;
    ASSERT_TRUE(clearlySeen().contains(entry.name)) << entry.name;
    EXPECT_TRUE(tableOf({{entry.name, clearlySeen().at(entry.name)}}) != baseline) << entry.name;
  }
}

TEST(WithheldGeneratorEffects, RaisedNoiseBringsEchoesOnlyIfAsked) {
  json world = model({{"thermal-noise", {{"temperature_degC", 85}}}});
  world["sensor"]["receiver"]["noise_w"] = 2e-9;
  const std::size_t quiet = generated(experiment({20}), world).at("range_m").size();
  world["effects"]["x-noise-echoes"] = json::object();
  EXPECT_EQ(quiet, 84U);
  EXPECT_GT(generated(experiment({20}), world).at("range_m").size(), 150U);
}

// A mirror at 45° before a side wall: the ghost lies where the way over the mirror ends, 10 m + 5 m.
TEST(WithheldGeneratorEffects, GhostStandsAtTheLengthOfTheDetour) {
  json package = experiment({10});
  package["materials"]["board"]["brdf"] = {{"model", "phong"}, {"diffuse_fraction", 0.5}, {"exponent", 20}};
  package["scene"][0] =
      object("mirror", {{"type", "rectangle"}, {"width_m", 4}, {"height_m", 4}}, {10, 0, 0}, "board", 45);
  package["scene"].push_back(
      object("side", {{"type", "rectangle"}, {"width_m", 40}, {"height_m", 40}}, {10, -5, 0}, "board", 90));
  const Table table = generated(package, model({{"multipath", json::object()}}));
  bool seen = false;
  for (std::size_t i = 0; i < table.at("range_m").size(); ++i) {
    if (std::abs(table.at("azimuth_rad")[i]) > 1e-6 || table.at("echo")[i] < 1.5) continue;
    EXPECT_NEAR(table.at("range_m")[i], 15.0 / std::cos(table.at("elevation_rad")[i]), 1e-3);
    seen = true;
  }
  EXPECT_TRUE(seen);
}

// By its definition the cloud has the same optical depth along a diameter as an even one: 2 k 2R on the way out and
// back.
TEST(WithheldGeneratorEffects, CloudTakesItsOpticalDepthAlongADiameter) {
  const withheld::Effects effects(
      {{"exhaust-cloud", {{"extinction_1_m", 0.3}, {"size_m", 2.0}, {"centre", {8, 0, 0}}, {"albedo", 0}}}}, "");
  const withheld::Profile profile = withheld::readProfile(sensor(), "");
  const withheld::Air air(effects, profile, {});
  const withheld::Ray ray{{0, 0, 0}, {1, 0, 0}};
  EXPECT_NEAR(air.left(ray, 20.0), std::exp(-2 * 0.3 * 2.0), 1e-12);
  EXPECT_NEAR(air.left(ray, 8.0), std::exp(-0.3 * 2.0), 1e-12);
  EXPECT_DOUBLE_EQ(air.left(ray, 6.9), 1.0);
}

// The soft target far out: ∫ β c τ/2 … of a short pulse, β exp(-2 α r)/r² times the length of the pulse.
TEST(WithheldGeneratorEffects, FogEchoHasThePowerOfItsPulseLength) {
  const withheld::Effects effects({{"atmospheric-backscatter", {{"visibility_m", 100}}}}, "");
  const withheld::Profile profile = withheld::readProfile(sensor(), "");
  const withheld::Air air(effects, profile, {});
  double sum = 0;
  for (const auto& arrival : air.sentBack({{0, 0, 0}, {1, 0, 0}}, 50.0, 1.0)) {
    if (arrival.range_m > 20.0 && arrival.range_m < 21.0) sum += arrival.power_w;
  }
  const double alpha = 3.912 / 100, middle = alpha / 20.0 * std::exp(-2 * alpha * 20.5) / (20.5 * 20.5);
  EXPECT_NEAR(sum, middle, 0.005 * middle);
}

TEST(WithheldGeneratorEffects, DeadTimeIsExtendedByWhatItHides) {
  const withheld::Profile profile = withheld::readProfile(sensor(), "");
  const withheld::Effects effects({{"dead-time", {{"dead_time_ns", 50}}}}, "");
  const withheld::Echoes echoes(profile, effects, {}, {4.0, 0.5});
  withheld::Dice outputs(1, withheld::Use::outputs, {}), losses(1, withheld::Use::losses, {});
  const auto at = [](double t) { return withheld::Waveform::Stretch{t, t + 5, t + 2.5, 1e-6}; };
  const auto seen = echoes.read({at(100), at(140), at(180), at(240)}, {}, 0, 2.5e-8, outputs, losses);
  ASSERT_EQ(seen.size(), 2U);  // 140 and 180 lie within 50 ns of the one before them, 240 does not
  EXPECT_NEAR(seen[1].range_m, 0.5 * 0.299792458 * 242.5, 1e-5);
}

// Dark current of silicon doubles about every 8 to 9 K near room temperature (Sze & Ng 2007).
TEST(WithheldGeneratorEffects, DarkCurrentDoublesAboutEveryEightKelvin) {
  EXPECT_DOUBLE_EQ(withheld::darkCurrentRatio(20.0), 1.0);
  EXPECT_NEAR(withheld::darkCurrentRatio(28.5), 2.0, 0.1);
}

// Normal incidence on n = 1.5: ((n-1)/(n+1))² = 4 %; at Brewster's angle only half of the rest is left.
TEST(WithheldGeneratorEffects, FresnelHasItsKnownValues) {
  EXPECT_NEAR(withheld::fresnel(1.0, 1.5), 0.04, 1e-15);
  const double brewster = std::cos(std::atan(1.5)), across = (1.5 * 1.5 - 1) / (1.5 * 1.5 + 1);
  EXPECT_NEAR(withheld::fresnel(brewster, 1.5), 0.5 * across * across, 1e-12);
}

// The fast vehicle stands where it was one delay ago.
TEST(WithheldGeneratorEffects, LatencyShowsWhereThingsWere) {
  json package = experiment({30});
  package["scene"][0]["velocity_m_s"] = {20, 0, 0};
  const Table now = generated(package, model(json::object()));
  const Table late = generated(package, model({{"latency", {{"delay_s", 0.1}}}}));
  for (std::size_t i = 0; i < now.at("range_m").size(); ++i) {
    EXPECT_NEAR(late.at("range_m")[i], now.at("range_m")[i] * 28.0 / 30.0, 1e-4);
  }
}

}  // namespace
