#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <set>

#include "tests/model/effects/shot_bench.h"

namespace model {
namespace {

using nlohmann::json;

double constant_w_m2() { return lab::radarEquation(1.0, std::numbers::pi); }

/// The published size distributions, in metres, and the law of one particle, written down again.
struct Kind {
  json parameters;
  double number_1_m4, slope_1_m, area, backscatter_1_sr;
  double smallest_m = 0.0;
};

Kind rain() { return {{{"rain_rate_mm_h", 20}, {"window_m", 0.02}}, 8e6, 4100 * std::pow(20, -0.21), 1.0, 2.0 / 18.8}; }

/// Without its small drops, and each sends less back.
Kind otherRain() {
  Kind kind = rain();
  kind.parameters["lidar_ratio_sr"] = 30;
  kind.parameters["smallest_drop_mm"] = 0.8;
  kind.backscatter_1_sr = 2.0 / 30.0;
  kind.smallest_m = 0.8e-3;
  return kind;
}

Kind snow() {
  return {{{"snow_rate_mm_h", 2}, {"window_m", 0.02}},
          3.8e6 * std::pow(2, -0.87),
          2550 * std::pow(2, -0.48),
          std::pow(10.0, 2.0 / 3.0),
          0.8 / std::numbers::pi};
}

constexpr double kNearest_m = 0.5;

lab::Case in(const Kind& kind) {
  lab::Case setup;
  setup.sensor["detection"]["min_range_m"] = kNearest_m;
  setup.effects["precipitation-clutter"] = kind.parameters;
  return setup;
}

double footprint_m2(double range_m) { return std::pow(0.02 + 0.003 * range_m, 2); }

/// P = C b σ / (A r²) solved for the diameter.
double diameterOf(double power_w, double range_m, const Kind& kind) {
  const double area_m2 =
      power_w * footprint_m2(range_m) * range_m * range_m / (constant_w_m2() * kind.backscatter_1_sr);
  return std::max(kind.smallest_m, std::sqrt(area_m2 / (kind.area * std::numbers::pi / 4.0)));
}

double meanNumberAbove(double power_w, const Kind& kind) {
  return lab::integral(
      kNearest_m, 200.0,
      [&](double r) {
        return footprint_m2(r) * kind.number_1_m4 / kind.slope_1_m *
               std::exp(-kind.slope_1_m * diameterOf(power_w, r, kind));
      },
      40000);
}

/// Powers of a shot's particles without the shade of nearer ones: b = P r² / (C · backscatter) is the share that one
/// takes from all behind it, both ways.
void addUnshaded(std::vector<Pulse> pulses, const Kind& kind, std::vector<double>& powers_w) {
  std::sort(pulses.begin(), pulses.end(), [](const Pulse& a, const Pulse& b) { return a.range_m < b.range_m; });
  double light = 1.0;
  for (const Pulse& pulse : pulses) {
    powers_w.push_back(pulse.power_w / light);
    const double blocked = powers_w.back() * pulse.range_m * pulse.range_m / (constant_w_m2() * kind.backscatter_1_sr);
    light *= (1.0 - blocked) * (1.0 - blocked);
  }
}

// Expected number from distribution and beam volume; a Poisson count, four standard errors.
TEST(PrecipitationClutter, NumberOverPowerFollowsSizeDistributionAndBeam) {
  constexpr int kFrames = 3000;
  for (const Kind& kind : {rain(), otherRain(), snow()}) {
    const lab::ShotBench bench(in(kind));
    std::vector<double> powers_w;
    for (int frame = 0; frame < kFrames; ++frame) {
      addUnshaded(bench.shot(frame).pulses, kind, powers_w);
    }
    for (const double power_w : {0.2 * lab::kThreshold_w, lab::kThreshold_w, 5.0 * lab::kThreshold_w}) {
      const auto count = std::count_if(powers_w.begin(), powers_w.end(), [&](double p) { return p > power_w; });
      const double expected = kFrames * meanNumberAbove(power_w, kind);
      ASSERT_GT(expected, 50.0);
      EXPECT_NEAR(static_cast<double>(count), expected, 4.0 * std::sqrt(expected)) << power_w;
    }
  }
}

// Campbell's formula for a Poisson process: E Π (1 - b_i)² = exp(-E Σ (2 b_i - b_i²)), and E Σ b = ∫ dr ∫ N(D) σ(D) dD
// above the least diameter, E Σ b² = ∫ dr ∫ N(D) σ(D)²/A(r) dD. Four standard errors of the mean.
TEST(PrecipitationClutter, ParticlesShadeWhatLiesBehind) {
  const Kind kind = rain();
  lab::Case setup = in(kind);
  setup.scene = {lab::board(15.0)};
  const lab::ShotBench bench(setup);
  const double clear_w = lab::radarEquation(15.0);
  std::vector<double> light;
  for (int frame = 0; frame < 4000; ++frame) {
    const std::vector<Pulse> pulses = bench.shot(frame).pulses;
    light.push_back(pulses[0].power_w / clear_w);
    for (const Pulse& pulse : pulses) ASSERT_LE(pulse.range_m, 15.0);
  }
  const double blocked = lab::integral(kNearest_m, 15.0, [&](double r) {
    const double d = diameterOf(0.1 * lab::kThreshold_w, r, kind), s = kind.slope_1_m, disc = std::numbers::pi / 4.0;
    const double squares = d * d / s + 2 * d / (s * s) + 2 / (s * s * s);
    const double fourth = std::pow(d, 4) / s + 4 * std::pow(d, 3) / std::pow(s, 2) + 12 * d * d / std::pow(s, 3) +
                          24 * d / std::pow(s, 4) + 24 / std::pow(s, 5);
    return kind.number_1_m4 * disc * std::exp(-s * d) * (2.0 * squares - disc / footprint_m2(r) * fourth);
  });
  EXPECT_GT(blocked, 1e-3);
  EXPECT_NEAR(lab::mean(light), std::exp(-blocked), 4.0 * lab::deviation(light) / std::sqrt(4000.0));
}

TEST(PrecipitationClutter, WithoutParametersTheExperimentsRainFalls) {
  lab::Case setup = in({json::object(), 0, 0, 0, 0});
  setup.frames = 200;
  EXPECT_EQ(lab::fire(setup).size(), 0u);
  setup.environment["rain_rate_mm_h"] = 20;
  EXPECT_GT(lab::fire(setup).size(), 0u);
}

constexpr double kDensity = 2.0, kLength_m = 8.0, kExtinction_1_m = 0.05;

/// A low vehicle that drives away at 100 km/h, its plume in the beam, a wall behind; two beams of the same direction.
lab::Case spray(double speed_m_s = 100.0 / 3.6) {
  lab::Case setup;
  setup.scene = {lab::object("car", {{"type", "box"}, {"size_m", {4, 1.8, 1}}}, {40, 0, -1.0}), lab::board(60)};
  setup.scene[0]["velocity_m_s"] = {speed_m_s, 0, 0};
  setup.sensor["scan"]["layers"].push_back(setup.sensor["scan"]["layers"][0]);
  setup.effects["road-spray"] = {{"density", kDensity},
                                 {"plume_length_m", kLength_m},
                                 {"plume_height_m", 3.0},
                                 {"extinction_1_m", kExtinction_1_m}};
  return setup;
}

double depthOf(const ShotRecord& shot) { return -0.5 * std::log(shot.pulses[0].power_w / lab::radarEquation(60)); }

/// E R³ of a lognormal radius that is cut at 1 m.
double meanCube() {
  constexpr double m = -1.2, s = 0.8;
  return std::exp(3 * m + 4.5 * s * s) * lab::normalCdf((-m - 3 * s * s) / s) + 1.0 - lab::normalCdf(-m / s);
}

// A ray along the plume, farther than a radius from its sides, meets every volume element with the same probability:
// mean optical depth = density · length · α · mean volume of a cluster. Four standard errors.
TEST(RoadSpray, MeanOpticalDepthIsThatOfTheClustersVolume) {
  const lab::ShotBench bench(spray());
  std::vector<double> depths;
  for (int frame = 0; frame < 4000; ++frame) depths.push_back(depthOf(bench.shot(frame)));
  const double expected = kDensity * kLength_m * kExtinction_1_m * 4.0 / 3.0 * std::numbers::pi * meanCube();
  EXPECT_NEAR(lab::mean(depths), expected, 4.0 * lab::deviation(depths) / std::sqrt(4000.0));
}

TEST(RoadSpray, AllBeamsOfAFrameMeetTheSameClusters) {
  const lab::ShotBench bench(spray());
  std::set<double> depths;
  for (int frame = 0; frame < 50; ++frame) {
    const ShotRecord first = bench.shot(frame, 0), second = bench.shot(frame, 1);
    ASSERT_EQ(first.pulses.size(), second.pulses.size());
    EXPECT_EQ(depthOf(first), depthOf(second));
    depths.insert(depthOf(first));
  }
  EXPECT_GT(depths.size(), 40u);
}

// Rear at 38 m, plume of 8 m, clusters of at most 1 m: false echoes stand there and nowhere else.
TEST(RoadSpray, EchoesStandInThePlume) {
  lab::Case setup = spray();
  setup.sensor["detection"]["echo_separation_m"] = 0.0;
  setup.sensor["receiver"]["threshold_w"] = 1e-9;
  setup.frames = 200;
  std::size_t false_echoes = 0;
  const core::Detections detections = lab::fire(setup);
  for (const double range_m : detections.range_m) {
    if (range_m > 50) continue;
    ++false_echoes;
    EXPECT_GT(range_m, 29.0);
    EXPECT_LT(range_m, 39.0);
  }
  EXPECT_GT(false_echoes, 100u);
}

TEST(RoadSpray, NobodySlowRaisesSpray) {
  for (const double speed_m_s : {0.0, 13.8}) {
    const ShotRecord shot = lab::ShotBench(spray(speed_m_s)).shot();
    ASSERT_EQ(shot.pulses.size(), 1u);
    EXPECT_NEAR(depthOf(shot), 0.0, 1e-12);
  }
}

}  // namespace
}  // namespace model
