#include "gap/replay/replay.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <optional>

#include "core/physics.h"
#include "gap/distance/discrepancy.h"
#include "model/simulate.h"
#include "tests/gap/small_world.h"

namespace {

using test_support::SmallWorld;

/// Mean intensity of the cells of sample r8 at an azimuth. [nW]
double intensityAt(const gap::Replay& replay, double azimuth_deg) {
  constexpr int kFrames = 200;
  for (std::size_t s = 0; s < replay.samples().size(); ++s) {
    const gap::ReplaySample& sample = replay.samples()[s];
    if (sample.sample->id != "r8") continue;
    const auto statistics = replay.simulate(replay.baseline(), s, kFrames, 1);
    double sum = 0.0, count = 0.0;
    for (std::size_t c = 0; c < sample.layout->surfaces(); ++c) {
      const model::Beam& beam = sample.beams[sample.layout->cells()[c].beam];
      if (std::abs(beam.azimuth_rad * core::kDegPerRad - azimuth_deg) > 0.1) continue;
      sum += statistics[c].sum[gap::kIntensity];
      count += statistics[c].count;
    }
    return sum / count;
  }
  return 0.0;
}

// The beam at 5 degrees is 2 mrad wide and even; the wall ends 0.95 mrad beside its axis, so it leaves 0.975 of the
// power. The outermost of 9 rays in a row lies 0.89 mrad beside the axis: all of them meet the wall. A plane wall
// returns cos³ of the azimuth (cos θ of Lambert's law, r⁻²).
TEST(Replay, ASurfaceThatEndsBeyondTheOutermostRayOfABeamLosesThePowerThatPassesIt) {
  const SmallWorld world;
  const model::LidarModel model = SmallWorld::modelWith({});
  model::Experiment experiment = world.measuredBy(model, 0.4);
  const double edge_rad = 5.0 * core::kRadPerDeg + 0.95e-3;
  experiment.json["scene"][0]["shape"]["width_m"] = 2.0 * 8.0 * std::tan(edge_rad);
  const gap::Replay replay(experiment, model, {.most_beams = 1000});
  const double expected = 0.975 * std::pow(std::cos(5.0 * core::kRadPerDeg) / std::cos(4.0 * core::kRadPerDeg), 3.0);
  EXPECT_NEAR(intensityAt(replay, 5.0) / intensityAt(replay, 4.0), expected, 0.004);
}

// What the finer grid of partly hit beams knows of edges, nobody sees who runs the model.
TEST(Replay, OnTheModelsOwnGridReportsWhatTheModelReportsWhenItIsRun) {
  const SmallWorld world;
  const model::LidarModel model = SmallWorld::modelWith({});
  model::Experiment experiment = world.measuredBy(model, 0.4);
  experiment.json["scene"][0]["shape"]["width_m"] = 2.0 * 8.0 * std::tan(5.0 * core::kRadPerDeg + 0.95e-3);
  const core::Detections as_run = model::simulate(experiment, model, 0, {}, 7);
  const auto replayed = [&](int edge_rays) {
    const gap::Replay replay(experiment, model, {.edge_rays = edge_rays, .joined = edge_rays > 0});
    return replay.detections(replay.baseline(), 0, 7);
  };
  EXPECT_EQ(replayed(0).range_m, as_run.range_m);
  EXPECT_EQ(replayed(0).intensity, as_run.intensity);
  EXPECT_NE(replayed(33).intensity, as_run.intensity) << "the test must see an edge";
}

// The beam at 5 degrees is parted by the upright corner of a box 0.2 mrad beside its axis: 0.4 of its power meets the
// front, the rest the side, which it grazes. Of 9 rays in a row 4 meet the front. By Lambert's law the front returns
// cos³ of the azimuth, and the side, at the corner, sin cos².
TEST(Replay, ABeamPartedByTheCornerOfABoxReturnsWhatBothFacesDo) {
  const SmallWorld world;
  const model::LidarModel model = SmallWorld::modelWith({});
  model::Experiment experiment = world.measuredBy(model, 0.4);
  const double azimuth_rad = 5.0 * core::kRadPerDeg, corner_y_m = 7.0 * std::tan(azimuth_rad + 0.2e-3);
  nlohmann::json& box = experiment.json["scene"][0];
  box["shape"] = {{"type", "box"}, {"size_m", {2.0, 4.0, 8.0}}};  // its middle is 8 m away in r8
  box["pose"]["position_m"][1] = corner_y_m + 2.0;
  const gap::Replay replay(experiment, model, {.most_beams = 1000});
  const auto front = [](double at_rad) { return std::pow(std::cos(at_rad), 3.0); };
  const double side = std::sin(azimuth_rad) * std::pow(std::cos(azimuth_rad), 2.0);
  const double expected = (0.4 * front(azimuth_rad) + 0.6 * side) / front(6.0 * core::kRadPerDeg);
  EXPECT_NEAR(intensityAt(replay, 5.0) / intensityAt(replay, 6.0), expected, 0.01);
}

// Worlds that differ in the pulse alone share their hits: whichever comes first must trace the same.
TEST(Replay, SharedHitsDoNotDependOnWhichWorldTracedThem) {
  const SmallWorld world;
  const model::LidarModel model = SmallWorld::modelWith({});
  const model::Experiment experiment = world.measuredBy(model, 0.4);
  const auto turned = [&](double pulse_ns) {
    gap::World changed{SmallWorld::modelWith({}, {{"/sensor/emitter/pulse_fwhm_ns", pulse_ns}}), {}, {}};
    changed.references.push_back({"/scene/0/pose/yaw_pitch_roll_deg/0", 80.0, {}});  // many ranges in a beam
    return changed;
  };
  const auto lastOf = [&](const std::vector<double>& pulses_ns) {
    const gap::Replay replay(experiment, model);
    core::Detections last;
    for (const double pulse_ns : pulses_ns) last = replay.detections(turned(pulse_ns), 0, 1);
    return std::make_pair(last.range_m, last.epw_m);
  };
  ASSERT_GT(lastOf({4.5}).first.size(), 100U);
  EXPECT_EQ(lastOf({4.5}), lastOf({200.0, 4.5}));
}

// Half of a half is a quarter, all over what is left.
TEST(Replay, IsThinnedFurtherFromTheBeamsThatItHas) {
  const SmallWorld world;
  const model::LidarModel model = SmallWorld::modelWith({});
  const model::Experiment experiment = world.measuredBy(model, 0.4);
  const gap::Replay all(experiment, model);
  const gap::Replay half = all.thinner(all.samples()[0].beams.size() / 2);
  const gap::Replay quarter = half.thinner(half.samples()[0].beams.size() / 2);
  const auto &of_half = half.samples()[0].taken, &of_quarter = quarter.samples()[0].taken;
  EXPECT_TRUE(std::includes(of_half.begin(), of_half.end(), of_quarter.begin(), of_quarter.end()));
  EXPECT_NEAR(static_cast<double>(of_quarter.size()), static_cast<double>(of_half.size()) / 2.0, 4.0);
  EXPECT_EQ(half.thinner(1000000).samples()[0].taken, of_half);
}

/// Of the first cell of a sample.
struct FirstCell {
  double error_m;  ///< of the difference of its mean ranges, measured and of many simulated frames
  double slant;    ///< how much longer its beam gets than the wall goes farther
};
FirstCell firstCell(const SmallWorld& world, const model::LidarModel& measured_by) {
  constexpr int kFrames = 200;
  const auto measured = world.measuredBy(measured_by, 0.4);
  const gap::Replay replay(measured, SmallWorld::modelWith({}));
  const auto simulated = replay.simulate(replay.baseline(), 0, kFrames, 1);
  const gap::ReplaySample& sample = replay.samples().front();
  const model::Beam& beam = sample.beams[sample.layout->cells().front().beam];
  return {gap::meanError(replay, sample, 0, gap::kRange, sample.statistics[0], simulated[0]),
          1.0 / (std::cos(beam.azimuth_rad) * std::cos(beam.elevation_rad))};
}

// A wall that is known to 5 mm to either side takes a mean to the next multiple of 0.2 m now and then.
TEST(Replay, AReferenceWithinItsToleranceMayTakeACountedRangeToTheNextStep) {
  SmallWorld world;
  const model::LidarModel counting = SmallWorld::modelWith({{"quantisation", {{"range_step_m", 0.2}}}});
  const FirstCell sure = firstCell(world, counting);
  world.knownToWithin(0.005);
  const double noise_m = SmallWorld::modelWith({}).sensor("").detection.range_noise_m;
  const double jump_m = std::sqrt(gap::jumpVariance(0.2, sure.slant * 0.01 / std::sqrt(12.0), noise_m));
  EXPECT_GT(jump_m, 0.003);
  EXPECT_NEAR(firstCell(world, counting).error_m, std::hypot(sure.error_m, jump_m), 0.01 * jump_m);
  EXPECT_LT(firstCell(world, SmallWorld::modelWith({})).error_m, jump_m) << "no steps, no jumps";
}

}  // namespace
