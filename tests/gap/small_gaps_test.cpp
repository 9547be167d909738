#include <gtest/gtest.h>

#include "core/physics.h"
#include "gap/candidates/significance.h"
#include "gap/causes/fit.h"
#include "gap/distance/discrepancy.h"
#include "gap/distance/extra_echoes.h"
#include "tests/gap/small_world.h"

// What is rare in every beam or small beside the noise of all cells, and still there.
namespace {

using test_support::SmallWorld;

/// Extra discrepancy of a world with these effects to the measurement, over all samples.
double extraWith(const gap::Replay& replay, const std::vector<model::ActiveEffect>& effects) {
  gap::World world = replay.baseline();
  for (const model::ActiveEffect& effect : effects) world.model = model::withEffect(world.model, effect);
  std::vector<gap::Comparison> comparisons;
  for (std::size_t s = 0; s < replay.samples().size(); ++s) {
    const gap::ReplaySample& sample = replay.samples()[s];
    comparisons.push_back(
        {s, sample.statistics, sample.frames, replay.simulate(world, s, sample.frames, 1), sample.frames});
  }
  return gap::extraDiscrepancy(replay, comparisons, {});
}

/// The same with this rate of false alarms.
double extraAt(const gap::Replay& replay, double rate_per_beam) {
  if (rate_per_beam == 0.0) return extraWith(replay, {});
  return extraWith(replay, {{"false-alarm", {.numbers = {{"rate_per_beam", rate_per_beam}}}, {}}});
}

TEST(ExtraEchoes, TheRightRateIsNearestThoughItsEchoesNeverComeInTheSameBeams) {
  const SmallWorld world;
  const auto truth = SmallWorld::modelWith({{"false-alarm", {{"rate_per_beam", 0.01}}}});
  const auto measured = world.measuredBy(truth, 0.4);
  const gap::Replay replay(measured, SmallWorld::modelWith({}));
  const double right = extraAt(replay, 0.01);
  EXPECT_LT(3.0 * right, extraAt(replay, 0.0));
  EXPECT_LT(right, extraAt(replay, 0.002));
  EXPECT_LT(right, extraAt(replay, 0.05));
}

TEST(ExtraEchoes, NothingIsFarFromNothing) {
  const SmallWorld world;
  const auto model = SmallWorld::modelWith({});
  const auto measured = world.measuredBy(model, 0.4);
  EXPECT_EQ(extraAt(gap::Replay(measured, model), 0.0), 0.0);
}

// Some fifteen echoes in each sample of 3280 shots have no mean that would tell, all of them together do. The rates of
// both are the same: 4000 pulses per second in the 1 µs in which a shot listens.
TEST(ExtraEchoes, TheStrengthOfRareOnesTellsWhoMakesThem) {
  const SmallWorld world;
  const auto truth = SmallWorld::modelWith({{"crosstalk", {{"rate_1_s", 4000.0}}}});
  const auto measured = world.measuredBy(truth, 0.4);
  const gap::Replay replay(measured, SmallWorld::modelWith({}));
  const double foreign = extraWith(replay, {{"crosstalk", {.numbers = {{"rate_1_s", 4000.0}}}, {}}});
  EXPECT_GT(extraAt(replay, 4000.0 * 2.0 * 149.7 / core::kSpeedOfLight_m_s), foreign + 50.0);
}

/// What the data say of a range offset of this size.
gap::Significance ofOffset(const gap::Replay& replay, double offset_m) {
  const gap::Split split = gap::splitOf(replay, 1);
  const gap::Judge judge{replay, split, gap::yardstickOf(replay, split.held_out)};
  gap::Candidate candidate;
  for (const gap::Hypothesis& hypothesis : gap::hypothesesFor(replay, {"range-offset"}))
    if (hypothesis.name == "range-offset") candidate.hypothesis = hypothesis;
  candidate.values = {offset_m};
  return gap::significanceOf(judge, candidate, gap::nullRunsOf(judge));
}

TEST(Significance, ASmallOffsetProvesItselfAndLeavesNothing) {
  const SmallWorld world;
  const auto truth = SmallWorld::modelWith({{"range-offset", {{"offset_m", 0.004}}}});  // a quarter of the noise
  const auto measured = world.measuredBy(truth, 0.4);
  const gap::Replay replay(measured, SmallWorld::modelWith({}));
  const gap::Significance right = ofOffset(replay, 0.004);
  EXPECT_GT(right.improvement_z, 6.0);
  EXPECT_LT(right.rest_z, 3.0);
  EXPECT_GT(right.without_best_z, 3.0);  // every sample shows it
  EXPECT_LT(ofOffset(replay, -0.004).improvement_z, 0.0);
}

TEST(Significance, WhatOneSampleAloneShowsIsGoneWithoutIt) {
  const SmallWorld world;
  const auto model = SmallWorld::modelWith({});
  const auto measured = world.measuredBy(model, 0.4, {{"r19", 0.008}});  // the other one held out stands as recorded
  const gap::Significance significance = ofOffset(gap::Replay(measured, model), 0.004);
  EXPECT_GT(significance.improvement_z, 4.0);
  EXPECT_LT(significance.without_best_z, 3.0);
}

TEST(Significance, NoOffsetIsProvenByNoise) {
  const SmallWorld world;
  const auto model = SmallWorld::modelWith({});
  const auto measured = world.measuredBy(model, 0.4);
  const gap::Replay replay(measured, model);
  EXPECT_LT(ofOffset(replay, 0.004).improvement_z, 4.0);
  EXPECT_LT(ofOffset(replay, -0.004).improvement_z, 4.0);
}

/// Relative error of the intensity of the beam at 5 degrees of r8, if the wall leaves it such a share of its power.
double intensityErrorAtEdge(double share) {
  const SmallWorld world;
  const auto model = SmallWorld::modelWith({});
  model::Experiment experiment = world.measuredBy(model, 0.4);
  const double edge_rad = 5.0 * core::kRadPerDeg + 2e-3 * (share - 0.5);  // the beam is 2 mrad wide and even
  experiment.json["scene"][0]["shape"]["width_m"] = 2.0 * 8.0 * std::tan(edge_rad);
  const gap::Replay replay(experiment, model, {.most_beams = 1000});
  const gap::ReplaySample& sample = replay.samples().front();
  const auto once = replay.simulate(replay.baseline(), 0, 200, 1),
             again = replay.simulate(replay.baseline(), 0, 200, 2);
  for (std::size_t c = 0; c < sample.layout->surfaces(); ++c) {
    if (std::abs(sample.beams[sample.layout->cells()[c].beam].azimuth_rad - 5.0 * core::kRadPerDeg) > 1e-3) continue;
    return gap::meanError(replay, sample, c, gap::kIntensity, once[c], again[c]) / again[c].mean(gap::kIntensity);
  }
  return 0.0;
}

// Two programs trace other sub-rays, and no real beam is as even as its profile: 0.004 of the beam are uncertain.
TEST(Discrepancy, KnowsTheFringeOfABeamNoBetterThanTheSubRaysDo) {
  EXPECT_NEAR(intensityErrorAtEdge(0.04), 0.1, 0.02);
  EXPECT_LT(intensityErrorAtEdge(0.96), 0.01);
}

}  // namespace
