#include <cmath>
#include <gtest/gtest.h>
#include <map>

#include "core/parallel.h"
#include "tests/model/effects/effect_bench.h"

namespace model {
namespace {

using nlohmann::json;

/// A narrow plate in the middle one of 41 beams.
lab::Case narrowPlate(double range_m, const json& parameters) {
  lab::Case setup;
  setup.scene = {lab::board(range_m, 0.02)};
  setup.sensor["scan"]["layers"][0]["azimuth_deg"] = {{"from", 10}, {"to", -10}, {"step", 0.5}};
  if (!parameters.is_null()) setup.effects["blooming"] = parameters;
  return setup;
}

// Spill at distance d passes the threshold while fraction · P / d² > P_th.
TEST(Blooming, TargetGrowsByTheBeamsInWhichTheSpillPassesTheThreshold) {
  for (const double range : {3.0, 5.0, 10.0}) {
    for (const double fraction : {1e-3, 1e-2}) {
      const auto reach = static_cast<std::size_t>(std::sqrt(fraction * lab::radarEquation(range) / lab::kThreshold_w));
      const auto detections = lab::fire(narrowPlate(range, {{"fraction", fraction}, {"neighbours", 20}}));
      EXPECT_EQ(detections.size(), 1 + 2 * std::min<std::size_t>(reach, 20)) << range << " " << fraction;
    }
  }
  EXPECT_EQ(lab::fire(narrowPlate(3, nullptr)).size(), 1u);
}

TEST(Blooming, SpillFallsWithTheSquareOfTheDistanceInBeams) {
  const auto detections = lab::fire(narrowPlate(3, {{"fraction", 1e-2}, {"neighbours", 4}}));
  ASSERT_EQ(detections.size(), 9u);
  for (int i = 0; i < 9; ++i) {
    const int d = std::abs(i - 4);
    const double share = d == 0 ? 1.0 : 1e-2 / (d * d);
    EXPECT_NEAR(1e-9 * detections.intensity[static_cast<std::size_t>(i)] / lab::radarEquation(3), share, 1e-5 * share);
    EXPECT_NEAR(detections.range_m[static_cast<std::size_t>(i)], 3, 1e-5);
  }
}

TEST(Blooming, StaysInItsLayerAndCountsAFootprintOnce) {
  lab::Case setup = narrowPlate(3, {{"fraction", 1e-2}, {"neighbours", 4}});
  setup.sensor["scan"]["layers"].push_back(setup.sensor["scan"]["layers"][0]);
  setup.sensor["scan"]["layers"][1]["elevation_deg"] = 5.0;
  setup.rays_per_beam = {9, 9};
  setup.effects["beam-divergence"] = json::object();
  setup.effects["pulse-broadening"] = json::object();
  const auto detections = lab::fire(setup);
  ASSERT_EQ(detections.size(), 9u);
  for (const auto layer : detections.layer) EXPECT_EQ(layer, 0);
  EXPECT_NEAR(detections.intensity[3] / detections.intensity[4], 1e-2, 1e-5);
}

// What spills is as it came: from a surface it glitters with it, from a relayed pulse it does not.
TEST(Blooming, SpillOfAFalseTargetDoesNotGlitter) {
  lab::Case setup = narrowPlate(3, {{"fraction", 1e-2}, {"neighbours", 2}});
  setup.scene.clear();
  setup.effects["spoofing"] = {{"azimuth_deg", 0.0}, {"width_deg", 0.01}, {"range_m", 8.0}, {"power_w", 1e-4}};
  setup.effects["speckle"] = {{"looks", 4.0}};
  setup.frames = 20;
  std::map<double, std::vector<double>> of_beam;
  const auto detections = lab::fire(setup);
  for (std::size_t i = 0; i < detections.size(); ++i) {
    of_beam[detections.azimuth_rad[i]].push_back(detections.intensity[i]);
  }
  EXPECT_EQ(of_beam.size(), 5U);
  for (const auto& [azimuth_rad, intensity] : of_beam) {
    EXPECT_EQ(intensity.size(), 20U);
    EXPECT_NEAR(lab::deviation(intensity) / lab::mean(intensity), 0.0, 1e-9) << azimuth_rad;
  }
}

TEST(Blooming, IsTheSameForAnyNumberOfThreads) {
  lab::Case setup = narrowPlate(5, {{"fraction", 1e-2}, {"neighbours", 20}});
  setup.scene.push_back(lab::board(30, 60, "grey", "wall"));
  setup.sensor["scan"]["layers"][0]["azimuth_deg"]["step"] = 0.02;
  setup.sensor["receiver"]["noise_w"] = 4e-9;
  setup.frames = 3;
  core::limitThreads(1);
  const auto one = lab::fire(setup);
  core::limitThreads(2);
  const auto two = lab::fire(setup);
  core::limitThreads(0);
  EXPECT_GT(one.size(), 1000u);
  EXPECT_EQ(one.range_m, two.range_m);
  EXPECT_EQ(one.intensity, two.intensity);
}

}  // namespace
}  // namespace model
