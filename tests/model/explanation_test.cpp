#include "model/explanation.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "tests/model/lab.h"

namespace model {
namespace {

struct Bench {
  explicit Bench(const lab::Case& setup) : experiment(lab::experimentOf(setup)), lidar(lab::modelOf(setup)) {}
  Experiment experiment;
  LidarModel lidar;
  Explainer explainer{experiment, lidar, 0};
};

lab::Case wideBeam() {
  lab::Case setup;
  setup.effects["beam-divergence"] = lab::json::object();
  setup.rays_per_beam = {8, 8};
  return setup;
}

TEST(Explanation, EverySubRayHasItsPowerAndTheyAddUpToTheRadarEquation) {
  lab::Case setup = wideBeam();
  setup.scene = {lab::board(40)};
  const Bench bench(setup);
  const BeamExplanation beam = bench.explainer.explain(0, 0);
  EXPECT_EQ(beam.reason, Reason::kDetected);
  ASSERT_EQ(beam.rays.size(), 64U);
  double sum_w = 0.0;
  for (const SubRayExplanation& ray : beam.rays) {
    EXPECT_EQ(ray.object, "board");
    EXPECT_EQ(ray.material, "grey");
    EXPECT_LE(std::abs(ray.azimuth_rad), 1.5e-3);
    sum_w += ray.power_w;
  }
  EXPECT_NEAR(sum_w / lab::radarEquation(40), 1.0, 1e-5);  // 3 mrad wide: cos and r differ by parts in a million
}

// The board covers the left half of the beam: the other sub-rays met nothing.
TEST(Explanation, SubRaysThatMissAreListedWithoutAnObject) {
  lab::Case setup = wideBeam();
  setup.scene = {lab::object("half", {{"type", "rectangle"}, {"width_m", 2}, {"height_m", 2}}, {40, 1, 0})};
  const BeamExplanation beam = Bench(setup).explainer.explain(0, 0);
  EXPECT_EQ(std::count_if(beam.rays.begin(), beam.rays.end(), [](const auto& ray) { return ray.object.empty(); }), 32);
}

TEST(Explanation, TheWaveformIsTheGaussianOfTheRadarEquation) {
  lab::Case setup;
  setup.scene = {lab::board(40)};
  const BeamExplanation beam = Bench(setup).explainer.explain(0, 0);
  const double width_m = 0.299792458 * lab::kFwhm_ns / 2.0;
  ASSERT_FALSE(beam.waveform.empty());
  for (const WaveformSample& sample : beam.waveform) {
    const double u = (sample.range_m - 40.0) / width_m;
    EXPECT_NEAR(sample.power_w, lab::radarEquation(40) * std::exp2(-4.0 * u * u), 1e-9 * lab::radarEquation(40));
  }
}

TEST(Explanation, EveryBeamWithoutADetectionHasItsReason) {
  const auto reasonWith = [](const lab::json& scene, const lab::json& effects) {
    lab::Case setup;
    setup.scene = scene;
    setup.effects = effects;
    return toString(Bench(setup).explainer.reasonOf(0, 0));
  };
  const lab::json none = lab::json::object();
  EXPECT_EQ(reasonWith(lab::json::array(), none), "no hit");
  EXPECT_EQ(reasonWith(lab::json::array({lab::board(40)}), none), "detected");
  EXPECT_EQ(reasonWith(lab::json::array({lab::board(900)}), none), "below threshold");
  EXPECT_EQ(reasonWith(lab::json::array({lab::board(40)}), {{"range-gating", {{"from_m", 50}}}}), "gated");
  EXPECT_EQ(reasonWith(lab::json::array({lab::board(40)}), {{"detection-loss", {{"probability", 1}}}}), "lost");
}

// Two boards in one beam, nearer to each other than the sensor separates: the farther one is part of the nearer echo.
TEST(Explanation, MergedEchoesAreNamed) {
  lab::Case setup = wideBeam();
  setup.sensor["detection"]["echo_separation_m"] = 5.0;
  setup.scene = {lab::object("half", {{"type", "rectangle"}, {"width_m", 2}, {"height_m", 2}}, {38, 1, 0}),
                 lab::board(41)};
  const BeamExplanation beam = Bench(setup).explainer.explain(0, 0);
  ASSERT_EQ(beam.shot.echoes.size(), 2U);
  EXPECT_EQ(toString(beam.shot.echoes[0].fate), "detected");
  EXPECT_EQ(toString(beam.shot.echoes[1].fate), "merged");
}

// What is explained is what is simulated, noise and all.
TEST(Explanation, DetectedEchoesAreThoseOfTheSimulation) {
  lab::Case setup = wideBeam();
  setup.sensor["scan"]["layers"][0]["azimuth_deg"] = {{"from", 4}, {"to", -4}, {"step", 0.5}};
  setup.sensor["receiver"]["noise_w"] = 4e-9;
  setup.sensor["detection"]["range_noise_m"] = 0.01;
  setup.effects["false-alarm"] = {{"rate_per_beam", 0.05}};
  setup.scene = {lab::board(30, 60),
                 lab::object("post", {{"type", "cylinder"}, {"radius_m", 0.2}, {"height_m", 4}}, {12, 0.2, 0})};
  setup.frames = 3;
  const core::Detections simulated = lab::fire(setup);
  const Bench bench(setup);
  std::vector<double> explained;
  for (int frame = 0; frame < 3; ++frame) {
    for (std::size_t b = 0; b < bench.explainer.beams().size(); ++b) {
      for (const Echo& echo : bench.explainer.explain(b, frame).shot.echoes) {
        if (echo.fate == Fate::kDetected) explained.push_back(echo.range_m);
      }
    }
  }
  EXPECT_EQ(explained, simulated.range_m);
}

}  // namespace
}  // namespace model
