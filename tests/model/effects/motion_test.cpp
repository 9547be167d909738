// motion-scan and latency: objects and sensor that move.
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "tests/model/effects/effect_bench.h"

namespace model {
namespace {

using nlohmann::json;

constexpr double kScan_s = 0.05;  // duty 0.5 of 10 Hz

/// A plate of 2 m across the x axis that moves, scanned from left to right in steps of 0.05 degrees.
lab::Case movingPlate(double range_m, const std::vector<double>& velocity_m_s, const json& effects) {
  lab::Case setup;
  setup.scene = {lab::board(range_m, 2)};
  setup.scene[0]["velocity_m_s"] = velocity_m_s;
  setup.sensor["scan"]["layers"][0]["azimuth_deg"] = {{"from", 20}, {"to", -20}, {"step", 0.05}};
  setup.effects = effects;
  return setup;
}

/// Detected beams among those whose outcome is sure (farther than a millimetre from an edge); -1 where it is wrong.
int beamsOnPlate(const lab::Case& setup, double speed_left_m_s, double delay_s, bool scanning) {
  const auto detections = lab::fire(setup);
  std::vector<bool> seen(801, false);
  for (const double azimuth : detections.azimuth_rad) {
    seen[static_cast<std::size_t>(std::lround((20 - azimuth * 180 / std::numbers::pi) / 0.05))] = true;
  }
  int count = 0;
  for (int k = 0; k < 801; ++k) {
    const double azimuth = (20 - 0.05 * k) * std::numbers::pi / 180;
    const double time_s = (scanning ? kScan_s * k / 801 : 0.0) - delay_s;
    const double off_centre = std::abs(20 * std::tan(azimuth) - speed_left_m_s * time_s);
    if (std::abs(off_centre - 1.0) < 1e-3) continue;
    if (seen[static_cast<std::size_t>(k)] != (off_centre < 1.0)) return -1;
    count += off_centre < 1.0;
  }
  return count;
}

// A beam at azimuth a and time t meets the plate if |20 tan a - v t| < 1 m. The scan runs to the right at about
// 20 m · 40 deg / 50 ms = 280 m/s at the centre, so a plate that runs along at 40 m/s looks 280/(280 - 40) as wide.
TEST(MotionScan, CrossingPlateIsMetWhereItStandsAtTheBeamsOwnTime) {
  const json on = {{"motion-scan", json::object()}};
  const int still = beamsOnPlate(movingPlate(20, {0, 0, 0}, on), 0, 0, true);
  const int along = beamsOnPlate(movingPlate(20, {0, -40, 0}, on), -40, 0, true);
  const int against = beamsOnPlate(movingPlate(20, {0, 40, 0}, on), 40, 0, true);
  ASSERT_GT(still, 100);
  const double sweep_m_s = 20 * (40 * std::numbers::pi / 180) / kScan_s;
  EXPECT_NEAR(along / (still * sweep_m_s / (sweep_m_s - 40)), 1.0, 0.02);
  EXPECT_NEAR(against / (still * sweep_m_s / (sweep_m_s + 40)), 1.0, 0.02);
}

TEST(MotionScan, ApproachingPlateComesNearerFromBeamToBeam) {
  const auto detections = lab::fire(movingPlate(20, {-30, 0, 0}, {{"motion-scan", json::object()}}));
  ASSERT_GT(detections.size(), 100u);
  for (std::size_t i = 0; i < detections.size(); ++i) {
    const double time_s = detections.time_s[i];
    EXPECT_NEAR(detections.range_m[i], (20 - 30 * time_s) / std::cos(detections.azimuth_rad[i]), 1e-4);
  }
}

// The sensor drives at the wall: the same as a wall that comes.
TEST(MotionScan, OwnSpeedIsThatOfTheSceneTurnedRound) {
  const auto own = lab::fire(movingPlate(20, {0, 0, 0}, {{"motion-scan", {{"ego_speed_m_s", 30}}}}));
  const auto others = lab::fire(movingPlate(20, {-30, 0, 0}, {{"motion-scan", json::object()}}));
  EXPECT_GT(own.size(), 100u);
  EXPECT_EQ(own.range_m, others.range_m);
  EXPECT_EQ(own.azimuth_rad, others.azimuth_rad);
}

TEST(MotionScan, OffNothingMoves) {
  const auto moving = lab::fire(movingPlate(20, {-30, 40, 0}, json::object()));
  const auto still = lab::fire(movingPlate(20, {0, 0, 0}, json::object()));
  EXPECT_EQ(moving.range_m, still.range_m);
  EXPECT_EQ(moving.azimuth_rad, still.azimuth_rad);
}

TEST(Latency, MovingTargetLagsByItsWayInTheDelay) {
  const auto late = lab::fire(movingPlate(20, {-30, 0, 0}, {{"latency", {{"delay_s", 0.1}}}}));
  const auto now = lab::fire(movingPlate(20, {-30, 0, 0}, json::object()));
  ASSERT_GT(late.size(), 50u);
  EXPECT_EQ(late.time_s[0], now.time_s[static_cast<std::size_t>((now.size() - late.size()) /
                                                                2)]);  // narrower, for it is farther; stamps stay
  for (std::size_t i = 0; i < late.size(); ++i) {
    EXPECT_NEAR(late.range_m[i], 23 / std::cos(late.azimuth_rad[i]), 1e-4);
  }
  EXPECT_GT(beamsOnPlate(movingPlate(20, {0, 10, 0}, {{"latency", {{"delay_s", 0.2}}}}), 10, 0.2, false), 100);
}

TEST(Latency, AddsToTheMotionOfTheScan) {
  const json both = {{"latency", {{"delay_s", 0.1}}}, {"motion-scan", json::object()}};
  EXPECT_GT(beamsOnPlate(movingPlate(20, {0, -20, 0}, both), -20, 0.1, true), 100);
}

}  // namespace
}  // namespace model
