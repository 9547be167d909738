#include <gtest/gtest.h>

#include "gap/extra_echoes.h"
#include "gap/fit.h"
#include "gap/significance.h"
#include "tests/gap/small_world.h"

// What is rare in every beam or small beside the noise of all cells, and still there.
namespace {

using test_support::SmallWorld;

/// Extra discrepancy of a world with this rate of false alarms to the measurement, over all samples.
double extraAt(const gap::Replay& replay, double rate_per_beam) {
  gap::World world = replay.baseline();
  if (rate_per_beam > 0.0)
    world.model = model::withEffect(world.model, {"false-alarm", {.numbers = {{"rate_per_beam", rate_per_beam}}}, {}});
  double sum = 0.0;
  for (std::size_t s = 0; s < replay.samples().size(); ++s) {
    const gap::ReplaySample& sample = replay.samples()[s];
    sum += gap::extraDiscrepancy(
        replay, {s, sample.statistics, sample.frames, replay.simulate(world, s, sample.frames, 1), sample.frames}, {});
  }
  return sum;
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

}  // namespace
