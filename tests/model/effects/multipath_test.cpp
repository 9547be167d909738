#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "tests/model/effects/effect_bench.h"

namespace model {
namespace {

using nlohmann::json;

/// A mirror at 10 m turns the beam to the right; a wall stands there at 5 m.
lab::Case mirrorAndWall(const json& mirror, const json& parameters = json::object()) {
  lab::Case setup;
  setup.materials["mirror"] = mirror;
  setup.scene = {
      lab::object("mirror", {{"type", "rectangle"}, {"width_m", 2}, {"height_m", 2}}, {10, 0, 0}, {45, 0, 0}, "mirror"),
      lab::object("wall", {{"type", "rectangle"}, {"width_m", 6}, {"height_m", 6}}, {10, -5, 0}, {90, 0, 0})};
  if (!parameters.is_null()) setup.effects["multipath"] = parameters;
  return setup;
}

double powerAt(const lab::Case& setup, double range_m) {
  double sum = 0.0;
  for (const Pulse& pulse : lab::pulses(setup)) {
    if (std::abs(pulse.range_m - range_m) < 1e-3) sum += pulse.power_w;
  }
  return sum;
}

const json kPolished = {{"reflectivity", 0.9},
                        {"brdf", {{"model", "phong"}, {"diffuse_fraction", 0.2}, {"exponent", 900}}}};

// The mirror image of the wall: laser radar equation over the whole path, twice through the mirror.
TEST(Multipath, GhostStandsAtTheLengthOfTheWholePath) {
  const lab::Case setup = mirrorAndWall(kPolished);
  EXPECT_NEAR(powerAt(setup, 15) / lab::radarEquation(15), std::pow(0.9 * 0.8, 2), 1e-4);
  const auto detections = lab::fire(setup);
  ASSERT_EQ(detections.size(), 2u);
  EXPECT_NEAR(detections.range_m[0], 10, 1e-3);
  EXPECT_NEAR(detections.range_m[1], 15, 1e-3);
  EXPECT_EQ(detections.azimuth_rad[1], 0.0);  // in the beam's own direction, behind the mirror
}

TEST(Multipath, OffAndWithoutMirrorsThereIsNoGhost) {
  EXPECT_EQ(lab::pulses(mirrorAndWall(kPolished, nullptr)).size(), 1u);
  EXPECT_EQ(lab::pulses(mirrorAndWall({{"reflectivity", 0.9}})).size(), 1u);
}

TEST(Multipath, GivenFractionSplitsEverySurfaceIntoMirrorAndDiffuse) {
  const lab::Case setup = mirrorAndWall({{"reflectivity", 0.9}}, {{"specular_fraction", 0.4}});
  EXPECT_NEAR(powerAt(setup, 15) / lab::radarEquation(15), std::pow(0.9 * 0.4, 2) * 0.6, 1e-4);
  EXPECT_NEAR(powerAt(setup, 10) / lab::radarEquation(10, 0.9, std::sqrt(0.5)), 0.6, 1e-4);
}

// Opaque glass at 45 degrees: R_p = R_s² (Fresnel), unpolarised light.
TEST(Multipath, GlassMirrorsByFresnel) {
  const double out = std::asin(std::sqrt(0.5) / 1.5);
  const double s = std::pow(std::sin(std::numbers::pi / 4 - out) / std::sin(std::numbers::pi / 4 + out), 2);
  const lab::Case setup = mirrorAndWall(
      {{"reflectivity", 0.05}, {"refractive_index", 1.5}, {"brdf", {{"model", "glass"}, {"roughness", 0.01}}}});
  EXPECT_NEAR(powerAt(setup, 15) / lab::radarEquation(15), std::pow(0.95 * 0.5 * (s + s * s), 2), 1e-6);
}

// Mirror, mirror, wall: three bounces, 10 + 5 + 4 m.
TEST(Multipath, CountsTheBouncesOfAPath) {
  const auto threeBounces = [](int most) {
    lab::Case setup = mirrorAndWall(kPolished, {{"max_bounces", most}});
    setup.scene[1] = lab::object("second", {{"type", "rectangle"}, {"width_m", 2}, {"height_m", 2}}, {10, -5, 0},
                                 {-135, 0, 0}, "mirror");
    setup.scene.push_back(lab::object("wall", {{"type", "rectangle"}, {"width_m", 4}, {"height_m", 4}}, {14, -5, 0}));
    return powerAt(setup, 19) / lab::radarEquation(19);
  };
  EXPECT_EQ(threeBounces(2), 0.0);
  EXPECT_NEAR(threeBounces(3), std::pow(0.9 * 0.8, 4), 1e-4);
}

}  // namespace
}  // namespace model
