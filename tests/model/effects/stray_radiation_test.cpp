#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "tests/model/effects/effect_bench.h"

namespace model {
namespace {

using nlohmann::json;

/// A reflector that begins a centimetre left of the beam's axis.
lab::Case reflectorBeside(double range_m, double fraction) {
  lab::Case setup;
  setup.materials["sign"] = {{"reflectivity", 0.5},
                             {"brdf", {{"model", "retroreflector"}, {"gain", 10000}, {"half_width_rad", 0.6}}}};
  const json plate = {{"type", "rectangle"}, {"width_m", 4}, {"height_m", 4}};
  setup.scene = {lab::object("sign", plate, {range_m, 2.01, 0}, {0, 0, 0}, "sign")};
  setup.effects["retroreflection"] = json::object();
  if (fraction > 0) setup.effects["stray-radiation"] = {{"fraction", fraction}, {"half_angle_rad", 0.02}};
  return setup;
}

// The reflector fills one half of the pedestal: P = f/2 · gain · laser radar equation. Within 20 mrad gain and cosine
// fall by less than 0.1 %.
TEST(StrayRadiation, ReflectorBesideTheBeamReturnsItsShareOfThePedestal) {
  const double expected = 1e-3 / 2 * 10000 * lab::radarEquation(20);
  EXPECT_NEAR(lab::power_w(reflectorBeside(20, 1e-3)) / expected, 1.0, 2e-3);
  EXPECT_NEAR(lab::power_w(reflectorBeside(20, 1e-4)) / expected, 0.1, 2e-4);
  EXPECT_EQ(lab::power_w(reflectorBeside(20, 0)), 0.0);
}

TEST(StrayRadiation, BrightTargetIsSeenInTheDirectionBesideIt) {
  const auto ghost = lab::fire(reflectorBeside(20, 1e-3));
  ASSERT_EQ(ghost.size(), 1u);
  EXPECT_EQ(ghost.azimuth_rad[0], 0.0);  // where nothing stands
  EXPECT_NEAR(ghost.range_m[0], 20, 20 * 0.02 * 0.02);
  EXPECT_EQ(lab::fire(reflectorBeside(20, 0)).size(), 0u);
  lab::Case grey = reflectorBeside(20, 1e-3);
  grey.effects.erase("retroreflection");  // its pedestal returns half a thousandth of 470 times the threshold
  EXPECT_EQ(lab::fire(grey).size(), 0u);
}

// What strays is missing in the beam: a wall in all of it returns the same, but for cos³ θ of the slanted sub-rays.
TEST(StrayRadiation, TakesFromTheBeamWhatItGivesToThePedestal) {
  lab::Case setup = lab::boardWith(20, "stray-radiation", {{"fraction", 0.01}, {"half_angle_rad", 0.02}});
  setup.effects["beam-divergence"] = json::object();
  setup.rays_per_beam = {3, 3};
  EXPECT_NEAR(lab::power_w(setup) / lab::radarEquation(20), 1.0, 1e-5);
  setup.scene = {lab::board(20, 0.1)};  // holds the beam of 60 mm and little of the pedestal
  EXPECT_NEAR(lab::power_w(setup) / lab::radarEquation(20), 0.99, 1e-5);
}

}  // namespace
}  // namespace model
