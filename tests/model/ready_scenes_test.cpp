#include <cmath>
#include <filesystem>
#include <functional>
#include <gtest/gtest.h>

#include "core/file.h"
#include "core/physics.h"
#include "model/geometry/ray_tracer.h"
#include "model/simulate.h"
#include "tests/support/paths.h"

// The scenes of resources/scenes. What a sensor must see there is worked out here again from lengths and angles that
// are written down by hand: tan and atan, not the ray tracer.
namespace model {
namespace {

constexpr double kDeg = core::kRadPerDeg;

std::filesystem::path scenesFolder() { return test_support::sourceFolder() / "resources/scenes"; }

struct Ready {
  Experiment experiment;
  LidarModel model;

  explicit Ready(const std::string& name)
      : experiment(readExperiment(scenesFolder() / name)), model(readModel(scenesFolder() / name / "model.json")) {}

  [[nodiscard]] core::Detections fire(const std::string& sample) const {
    return simulate(experiment, model, experiment.sampleIndex(sample));
  }
  [[nodiscard]] core::Detections fire(const std::string& sample, const Gate& gate) const {
    return insideGate(fire(sample), situationOf(experiment, experiment.samples[experiment.sampleIndex(sample)]), gate);
  }
};

/// A scan written down again: layers with their azimuths, and half of the beam's widths.
struct Fan {
  double elevation_deg, from_deg, to_deg, step_deg;
};
struct Scan {
  std::vector<Fan> layers;
  double half_left_rad, half_up_rad;
};
// Gaussian beams are sampled over ±1.5 of their half 1/e² widths.
const Scan kDemoScanner{{{-1.2, -50, 50, 0.25}, {-0.4, -50, 50, 0.25}, {0.4, -50, 50, 0.25}, {1.2, -50, 50, 0.25}},
                        1.5 * 0.0007,
                        1.5 * 0.007};
const Scan kIbeo{{{-1.2, -50.25, 50.25, 0.5}, {-0.4, -50.25, 50.25, 0.5}, {0.4, -60, 36, 0.5}, {1.2, -60, 36, 0.5}},
                 0.001396 / 2,
                 0.013683 / 2};

/// How many beams of a frame lie wholly in, and at least touch, a rectangle across the x axis.
struct Count {
  int whole = 0, touching = 0;
};
Count beamsOn(const Scan& scan, double x, double y_low, double y_high, double z_low, double z_high) {
  Count count;
  for (const Fan& layer : scan.layers) {
    const int columns = static_cast<int>(std::lround((layer.to_deg - layer.from_deg) / layer.step_deg)) + 1;
    for (int k = 0; k < columns; ++k) {
      const double azimuth = (layer.from_deg + k * layer.step_deg) * kDeg;
      int on = 0;
      for (const double left : {-scan.half_left_rad, scan.half_left_rad}) {
        for (const double up : {-scan.half_up_rad, scan.half_up_rad}) {
          const double y = x * std::tan(azimuth + left);
          const double z = x / std::cos(azimuth) * std::tan(layer.elevation_deg * kDeg + up);
          if (y >= y_low && y <= y_high && z >= z_low && z <= z_high) ++on;
        }
      }
      // Corners decide, because every rectangle here is wider and higher than a beam's footprint.
      if (on == 4) ++count.whole;
      if (on > 0) ++count.touching;
    }
  }
  return count;
}

TEST(ReadyScenes, EachOneReadsAndYieldsDetections) {
  int scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(scenesFolder())) {
    if (!entry.is_directory()) continue;
    ++scenes;
    const Ready ready(entry.path().filename().string());
    EXPECT_EQ(ready.experiment.id, entry.path().filename().string());
    EXPECT_FALSE(ready.experiment.source.empty());
    for (const Sample& sample : ready.experiment.samples) {
      EXPECT_TRUE(sample.measurements.empty()) << "a scene holds no measurements";
    }
    EXPECT_GT(ready.fire(ready.experiment.samples.front().id).size(), 100U) << ready.experiment.id;
  }
  EXPECT_GE(scenes, 5);
}

TEST(ReadyScenes, WallIsSeenByAsManyBeamsAsTrigonometrySays) {
  const Ready ready("wall");
  const core::Detections seen = ready.fire("wall");
  const Count expected = beamsOn(kDemoScanner, 10.0, -3.0, 3.0, -1.5, 1.5);
  ASSERT_EQ(expected.whole, 4 * 133);  // |azimuth| <= 16.5°, since atan(0.3) = 16.7°
  EXPECT_GE(seen.size(), 50U * expected.whole);
  EXPECT_LE(seen.size(), 50U * expected.touching);
  double sum = 0.0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const double error = seen.range_m[i] - 10.0 / (std::cos(seen.azimuth_rad[i]) * std::cos(seen.elevation_rad[i]));
    ASSERT_LT(std::abs(error), 0.07);  // noise of 0.01 m, rounding, and 3 mm of slant at the wall's ends
    sum += error;
  }
  EXPECT_NEAR(sum / static_cast<double>(seen.size()), 0.0, 0.002);
}

TEST(ReadyScenes, HangarBoardIsSeenByAsManyBeamsAsTrigonometrySays) {
  const Ready ready("hangar-sweep");
  EXPECT_EQ(ready.experiment.samples.size(), 11U);
  for (const Sample& sample : ready.experiment.samples) {
    const double x = sample.parameters.at("range_m");
    const Count expected = beamsOn(kIbeo, x, -0.5, 0.5, -0.5, 0.5);
    const core::Detections seen = ready.fire(sample.id, ready.experiment.gates.front());
    EXPECT_GE(seen.size(), 20U * expected.whole) << sample.id;
    // Beyond 30 m a beam is higher than the board: corners no longer decide who touches it.
    if (x <= 30.0) {
      EXPECT_LE(seen.size(), 20U * expected.touching) << sample.id;
    }
    EXPECT_GT(seen.size(), 0U) << sample.id;
  }
}

// The front car's near left corner hides what lies behind: its azimuth is the shadow's edge. Sizes from the scene's
// text: 4.5 m × 1.8 m, centres at (12, 0) and (22, 1.2).
const double kShadowEdge_rad = std::atan2(0.9, 12.0 - 2.25);
const double kRearLeft_rad = std::atan2(1.2 + 0.9, 22.0 - 2.25);

TEST(ReadyScenes, ShadowOfTheFrontCarEndsWhereItsCornerSays) {
  const Ready ready("parked-cars");
  const Scene scene = situationOf(ready.experiment, ready.experiment.samples[0]).scene;
  const RayTracer tracer(scene);
  std::vector<Ray> rays;
  constexpr double kStep_rad = 1e-5;
  for (double azimuth = 0.0; azimuth < 0.15; azimuth += kStep_rad) {
    rays.push_back({{}, {std::cos(azimuth), std::sin(azimuth), 0.0}});
  }
  std::vector<RayHit> hits(rays.size());
  tracer.trace(rays, hits);
  std::vector<double> changes;
  for (std::size_t i = 1; i < hits.size(); ++i) {
    if (hits[i].object != hits[i - 1].object) changes.push_back((static_cast<double>(i) - 0.5) * kStep_rad);
  }
  ASSERT_EQ(changes.size(), 2U);  // front car, rear car, nothing
  EXPECT_NEAR(changes[0], kShadowEdge_rad, kStep_rad);
  EXPECT_NEAR(changes[1], kRearLeft_rad, kStep_rad);
}

TEST(ReadyScenes, RearCarIsSeenBesideTheShadowOnly) {
  const Ready ready("parked-cars");
  const core::Detections rear = ready.fire("parked", ready.experiment.gates.at(1));
  // The middle layers (±0.4°) meet the bodies of both cars in full height. Azimuths from the profile: -0.4° fires at
  // 5.25°, 5.75° …, +0.4° at 5.5°, 6.0° …; the edge is at 5.27°, the rear car ends at 6.07°.
  int in_shadow = 0, beside = 0;
  for (std::size_t i = 0; i < rear.size(); ++i) {
    if (rear.azimuth_rad[i] < kShadowEdge_rad - kIbeo.half_left_rad) ++in_shadow;
    if (std::abs(std::abs(rear.elevation_rad[i]) - 0.4 * kDeg) > 1e-6) continue;
    if (rear.azimuth_rad[i] > kShadowEdge_rad + kIbeo.half_left_rad) ++beside;
    EXPECT_LT(rear.azimuth_rad[i], kRearLeft_rad + kIbeo.half_left_rad);
  }
  EXPECT_EQ(in_shadow, 0);
  EXPECT_EQ(beside, 20 * 3);  // 5.5°, 5.75° and 6.0°, in each of 20 frames
}

TEST(ReadyScenes, NothingInTheCrossingIsSeenBelowTheRoad) {
  const Ready ready("urban-crossing");
  const Scene scene = situationOf(ready.experiment, ready.experiment.samples[0]).scene;
  EXPECT_GT(scene.objects.size(), 300U);
  const core::Detections seen = ready.fire("noon");
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const double below = -seen.range_m[i] * std::sin(seen.elevation_rad[i]);
    ASSERT_LT(below, 1.8 + 0.011 * seen.range_m[i] + 0.1);  // a footprint's half height, noise
  }
  // Houses on both sides and cars ahead: at least half of all beams must come back from within 100 m.
  const std::size_t fired = 2 * beamsOfSample(ready.experiment, ready.model, ready.experiment.samples[0]).size();
  EXPECT_GT(seen.size(), fired / 2);
}

TEST(ReadyScenes, MotorwayShowsLessTheThickerTheAir) {
  const Ready ready("motorway");
  const std::size_t clear = ready.fire("clear").size(), haze = ready.fire("haze").size(),
                    fog = ready.fire("fog").size();
  EXPECT_GT(clear, haze);
  EXPECT_GT(haze, fog);
  // The nearest lorry's back, 19 m ahead, y = 3.0 … 5.5 m: fog takes two thirds of its light and leaves it in sight.
  const Count back = beamsOn(kDemoScanner, 19.0, 3.0, 5.5, -0.5, 2.3);
  EXPECT_GT(back.whole, 60);
  const core::Detections lorry = ready.fire("fog", {.id = "g", .object = "ahead-0-load", .margin_m = 0.1});
  EXPECT_GE(lorry.size(), 5U * back.whole);
}

TEST(ReadyScenes, MovingThingsHaveVelocitiesAndOthersNone) {
  for (const char* name : {"urban-crossing", "motorway"}) {
    const Ready ready(name);
    int moving = 0;
    for (const SceneObject& object : situationOf(ready.experiment, ready.experiment.samples[0]).scene.objects) {
      const bool moves = object.velocity_m_s != Vector3{};
      const bool should = object.id.find("moving") == 0 || object.id.find("ahead") == 0 ||
                          object.id.find("oncoming") == 0 || object.id.find("person") == 0;
      EXPECT_EQ(moves, should) << object.id;
      moving += moves ? 1 : 0;
    }
    EXPECT_GT(moving, 30) << name;
  }
}

}  // namespace
}  // namespace model
