#include "model/sensor/link_budget.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/physics.h"
#include "core/random.h"
#include "tests/model/lab.h"

namespace model {
namespace {

SensorProfile labSensor(double noise_w = 0.0) {
  nlohmann::json json = lab::sensor();
  json["receiver"]["noise_w"] = noise_w;
  return resolveSensorProfile(json, "m.json", "/sensor");
}

// The bench's own laser radar equation, written down independently.
TEST(LinkBudget, PowerIsThatOfTheLaserRadarEquation) {
  for (const double range_m : {1.0, 17.0, 250.0}) {
    EXPECT_NEAR(receivedPower_w(labSensor(), {.reflectivity = 0.3}, range_m) / lab::radarEquation(range_m, 0.3), 1.0,
                1e-12);
  }
  EXPECT_NEAR(receivedPower_w(labSensor(), {.reflectivity = 0.3, .gain = 0.25}, 9.0),
              0.25 * lab::radarEquation(9.0, 0.3), 1e-18);
}

TEST(LinkBudget, RangeInvertsPowerInClearAirAndInFog) {
  for (const double extinction : {0.0, 1e-9, 1e-4, 0.01, 0.3}) {
    const LinkTarget target{.reflectivity = 0.1, .extinction_1_m = extinction};
    for (const double power_w : {1e-10, 1e-8, 1e-5}) {
      const double range_m = rangeOfPower_m(labSensor(), target, power_w);
      EXPECT_NEAR(receivedPower_w(labSensor(), target, range_m) / power_w, 1.0, 1e-9) << extinction;
    }
  }
}

// In clear air P ∝ Γ/r²: eightfold reflectivity reaches sqrt(8) times as far.
TEST(LinkBudget, ReachGrowsWithTheRootOfReflectivity) {
  const double reflectivities[] = {0.1, 0.8};
  const std::optional<double> clear[] = {std::nullopt};
  const auto rows = linkBudget(labSensor(), reflectivities, clear);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_NEAR(rows[1].half_m / rows[0].half_m, std::sqrt(8.0), 1e-12);
}

// The table against the signal chain itself: at its ranges one half and 99 % of all frames show the board. Tolerance:
// four deviations of a binomial share of 4000 frames.
TEST(LinkBudget, ChainDetectsAsOftenAsTheTableSays) {
  constexpr int kFrames = 4000;
  lab::Case setup;
  setup.sensor["receiver"]["noise_w"] = 2e-9;
  setup.frames = kFrames;
  setup.materials["grey"]["reflectivity"] = 0.1;
  const double reflectivities[] = {0.1};
  const std::optional<double> visibilities[] = {std::nullopt, 500.0};
  const auto rows = linkBudget(labSensor(2e-9), reflectivities, visibilities);
  for (const LinkBudgetRow& row : rows) {
    if (row.visibility_m) setup.effects = {{"atmospheric-attenuation", {{"visibility_m", *row.visibility_m}}}};
    for (const auto& [range_m, share] : {std::pair{row.half_m, 0.5}, {row.sure_m, 0.99}}) {
      setup.scene = {lab::board(range_m, 400.0)};
      const double detected = static_cast<double>(lab::fire(setup).size()) / kFrames;
      EXPECT_NEAR(detected, share, 4.0 * std::sqrt(share * (1.0 - share) / kFrames)) << range_m;
    }
  }
}

// Brute force: white noise through a Gaussian filter as wide as the pulse, its rises above the level counted.
TEST(LinkBudget, FalseAlarmsAreTheCrossingsOfFilteredNoise) {
  constexpr double kRatio = 2.0;
  constexpr int kSamples = 400'000;
  SensorProfile sensor = labSensor();
  sensor.receiver.noise_w = 1e-9;
  sensor.receiver.threshold_w = kRatio * 1e-9;
  const double deviation_ns = sensor.emitter.pulse_fwhm_ns / (2.0 * std::sqrt(2.0 * std::log(2.0)));
  const double step_ns = deviation_ns / 10.0;
  std::vector<double> kernel;
  double energy = 0.0;
  for (int k = -50; k <= 50; ++k) {
    kernel.push_back(std::exp(-0.5 * std::pow(k * step_ns / deviation_ns, 2)));
    energy += kernel.back() * kernel.back();
  }
  core::Random random(core::Random::Key{.seed = 5});
  std::vector<double> white(kSamples + kernel.size());
  for (double& value : white) value = random.normal();
  int rises = 0;
  double before = 0.0;
  for (int i = 0; i < kSamples; ++i) {
    double filtered = 0.0;
    for (std::size_t k = 0; k < kernel.size(); ++k) filtered += kernel[k] * white[static_cast<std::size_t>(i) + k];
    filtered /= std::sqrt(energy);
    if (i > 0 && before <= kRatio && filtered > kRatio) ++rises;
    before = filtered;
  }
  const double window_m = sensor.detection.max_range_m - sensor.detection.min_range_m;
  const double window_ns = 2.0 * window_m / core::kMetresPerNanosecond;
  const double expected = falseAlarmsPerBeam(sensor) / window_ns * kSamples * step_ns;
  EXPECT_NEAR(rises, expected, 4.0 * std::sqrt(expected));
  EXPECT_GT(expected, 300.0);
}

TEST(LinkBudget, WithoutNoiseThereAreNoFalseAlarms) { EXPECT_EQ(falseAlarmsPerBeam(labSensor()), 0.0); }

}  // namespace
}  // namespace model
