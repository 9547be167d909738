#include <cmath>
#include <gtest/gtest.h>

#include "tests/model/effects/effect_bench.h"

namespace model {
namespace {

using nlohmann::json;

// A binomial proportion: four standard errors.
TEST(DetectionLoss, LosesTheGivenShare) {
  lab::Case setup = lab::boardWith(20, "detection-loss", {{"probability", 0.12}});
  setup.frames = 20000;
  const double lost = 1 - static_cast<double>(lab::fire(setup).size()) / setup.frames;
  EXPECT_NEAR(lost, 0.12, 4 * std::sqrt(0.12 * 0.88 / setup.frames));
}

// A Poisson count, four standard errors; ranges uniform; just above the threshold, hence narrow.
TEST(FalseAlarm, EchoesLieAnywhereAndBarelyTopTheThreshold) {
  lab::Case setup = lab::boardWith(20, "false-alarm", {{"rate_per_beam", 0.05}});
  setup.scene = json::array();
  setup.sensor["receiver"]["noise_w"] = 4e-9;
  setup.sensor["detection"]["max_range_m"] = 200;
  setup.frames = 60000;
  const auto detections = lab::fire(setup);
  EXPECT_NEAR(static_cast<double>(detections.size()), 3000, 4 * std::sqrt(3000.0));
  EXPECT_NEAR(lab::mean(detections.range_m), 100, 4 * 200 / std::sqrt(12 * 3000.0));
  // Excess: exponential with mean σ²/P_th.
  EXPECT_NEAR(lab::mean(detections.intensity), 20 + 16.0 / 20, 4 * 0.8 / std::sqrt(3000.0));
}

TEST(AngleClipping, ChangesNoByte) {
  lab::Case setup = lab::boardWith(20);
  setup.sensor["receiver"]["noise_w"] = 4e-9;
  setup.frames = 50;
  const auto off = lab::fire(setup);
  setup.effects["angle-clipping"] = json::object();
  const auto on = lab::fire(setup);
  EXPECT_EQ(on.range_m, off.range_m);
  EXPECT_EQ(on.azimuth_rad, off.azimuth_rad);
}

}  // namespace
}  // namespace model
