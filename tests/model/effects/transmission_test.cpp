#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "tests/model/effects/effect_bench.h"

namespace model {
namespace {

using nlohmann::json;

/// Panes at the given ranges before a wall at 20 m.
lab::Case window(const std::vector<double>& ranges_m, const json& parameters = json::object(), double slant_deg = 0) {
  lab::Case setup;
  setup.materials["glass"] = {{"reflectivity", 0.2}, {"transmission", 0.8}, {"refractive_index", 1.5}};
  setup.scene = {lab::board(20)};
  for (const double range : ranges_m) {
    setup.scene.push_back(lab::object("pane" + std::to_string(setup.scene.size()),
                                      {{"type", "rectangle"}, {"width_m", 8}, {"height_m", 8}}, {range, 0, 0},
                                      {slant_deg, 0, 0}, "glass"));
  }
  if (!parameters.is_null()) setup.effects["transmission"] = parameters;
  return setup;
}

double powerAt(const lab::Case& setup, double range_m) {
  double sum = 0.0;
  for (const Pulse& pulse : lab::pulses(setup)) {
    if (std::abs(pulse.range_m - range_m) < 1e-3) sum += pulse.power_w;
  }
  return sum;
}

// A material's reflectivity is hemispherical: it counts all light that falls on the pane, not what does not pass.
TEST(Transmission, PanePassesTheSquareOfItsTransmissionAndKeepsItsReflectivity) {
  EXPECT_NEAR(powerAt(window({10}), 20) / lab::radarEquation(20), 0.64, 1e-5);
  EXPECT_NEAR(powerAt(window({10}), 10) / lab::radarEquation(10, 0.2), 1.0, 1e-5);
  EXPECT_NEAR(powerAt(window({10}, {{"transmission", 0.5}}), 20) / lab::radarEquation(20), 0.25, 1e-5);
}

TEST(Transmission, BothSurfacesGiveEchoesAtTheirRanges) {
  const auto detections = lab::fire(window({10}));
  ASSERT_EQ(detections.size(), 2u);
  EXPECT_NEAR(detections.range_m[0], 10, 1e-4);
  EXPECT_NEAR(detections.range_m[1], 20, 1e-3);
}

TEST(Transmission, EveryPaneWeakensWhatLiesBehind) {
  EXPECT_NEAR(powerAt(window({10, 15}), 15) / lab::radarEquation(15, 0.2), 0.64, 1e-5);
  EXPECT_NEAR(powerAt(window({10, 15}), 20) / lab::radarEquation(20), 0.64 * 0.64, 1e-5);
  EXPECT_EQ(powerAt(window({5, 10, 15}), 20), 0.0);  // no more than two panes
}

// Fresnel's equations in the form of sines and tangents. Clear glass, all reflections in the pane summed:
// T = (1 - R)/(1 + R) for each polarisation.
TEST(Transmission, SlantedClearPaneFollowsFresnel) {
  for (const double slant_deg : {20.0, 45.0, 70.0}) {
    const double in = slant_deg * std::numbers::pi / 180, out = std::asin(std::sin(in) / 1.5);
    const double s = std::pow(std::sin(in - out) / std::sin(in + out), 2);
    const double p = std::pow(std::tan(in - out) / std::tan(in + out), 2);
    const double passes = 0.5 * ((1 - s) / (1 + s) + (1 - p) / (1 + p));
    const lab::Case setup = window({10}, {{"transmission", 1.0}, {"refractive_index", 1.5}}, slant_deg);
    EXPECT_NEAR(powerAt(setup, 20) / lab::radarEquation(20), passes * passes, 1e-5) << slant_deg;
    EXPECT_NEAR(powerAt(setup, 10) / lab::radarEquation(10, 0.2, std::cos(in)), 1.0, 1e-5) << slant_deg;
  }
}

TEST(Transmission, OffLeavesGlassOpaqueAndOnLeavesOtherSurfaces) {
  const auto opaque = lab::fire(window({10}, nullptr));
  ASSERT_EQ(opaque.size(), 1u);
  EXPECT_NEAR(1e-9 * opaque.intensity[0] / lab::radarEquation(10, 0.2), 1.0, 1e-6);
  lab::Case wall = lab::boardWith(10, "transmission", {{"transmission", 0.9}});
  EXPECT_NEAR(lab::power_w(wall) / lab::radarEquation(10), 1.0, 1e-9);
}

// Dust on a pane with the BRDF `glass` hides its share of what lies behind.
TEST(Transmission, DustOnGlassHidesItsShare) {
  lab::Case setup = window({10});
  setup.materials["glass"]["brdf"] = {{"model", "glass"}, {"roughness", 0.01}};
  EXPECT_NEAR(powerAt(setup, 20) / lab::radarEquation(20), std::pow(0.8 * 0.8, 2), 1e-5);
  EXPECT_NEAR(powerAt(setup, 10) / lab::radarEquation(10, 0.2), 1.0, 1e-5);
}

}  // namespace
}  // namespace model
