#include "gap/candidates/cross_fit.h"

#include <gtest/gtest.h>

#include "tests/gap/small_world.h"

// A small cause proves itself by the samples that were held out, and once more by the others.
namespace {

using test_support::SmallWorld;

struct Proof {
  gap::Significance held_out;
  gap::Significance both_ways;
};

/// What the data say of a range offset, as it fits the samples that are not held out.
Proof proofOfOffset(const model::Experiment& measured) {
  const gap::Replay replay(measured, SmallWorld::modelWith({}));
  const gap::Split split = gap::splitOf(replay, 1);
  const gap::Judge judge{replay, split, gap::yardstickOf(replay, split.held_out)};
  gap::Candidate candidate;
  for (const gap::Hypothesis& hypothesis : gap::hypothesesFor(replay, {"range-offset"}))
    if (hypothesis.name == "range-offset") candidate.hypothesis = hypothesis;
  const core::SilentProgress progress;
  candidate.values = gap::refine(replay, candidate.hypothesis, split.refined, {0.0}, progress);
  EXPECT_TRUE(gap::CrossFit::applies(judge, candidate.hypothesis));
  const gap::NullRuns nulls = gap::nullRunsOf(judge);
  const gap::NullRuns::Gains gains = nulls.gainsOf(gap::worldOf(replay, candidate.hypothesis, candidate.values));
  const gap::CrossFit others(judge, judge, nulls.runs());
  return {gap::significanceOf(gains, 0.0),
          gap::significanceOf(gap::joined(gains, others.gainsOf(candidate.hypothesis, progress)), 0.0)};
}

// Two samples are held out, four are not: three times the data, so up to 1.7 times the standard score.
TEST(CrossFit, WhatActsInEverySetUpIsMoreCertainByAllOfThem) {
  const SmallWorld world;
  const auto truth = SmallWorld::modelWith({{"range-offset", {{"offset_m", 0.002}}}});  // an eighth of the noise
  const Proof proof = proofOfOffset(world.measuredBy(truth, 0.4));
  EXPECT_GT(proof.held_out.improvement_z, 2.0);
  EXPECT_GT(proof.both_ways.improvement_z, 1.2 * proof.held_out.improvement_z);
  EXPECT_GT(proof.both_ways.gain, proof.held_out.gain);
}

// What stands elsewhere in the held-out set-ups only gains there with any value of that sign, and nowhere else.
TEST(CrossFit, WhatOnlyTheHeldOutSamplesShowIsLessCertainByAll) {
  const SmallWorld world;
  const auto measured = world.measuredBy(SmallWorld::modelWith({}), 0.4, {{"r19", 0.006}, {"r36", 0.006}});
  const Proof proof = proofOfOffset(measured);
  EXPECT_LT(proof.both_ways.improvement_z, 2.0);
}

// Of 12 experiments in which nothing is missing the joint scores are standard normal: their mean square stays below
// 2.74 in 999 of 1000 cases (chi-squared of 12), and hardly one is beyond 3.7.
TEST(CrossFit, WhereNothingIsMissingTheJointScoreIsOneOfChance) {
  double squares = 0.0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SmallWorld world;
    world.measuredUnder(50 * seed);
    const double z = proofOfOffset(world.measuredBy(SmallWorld::modelWith({}), 0.4)).both_ways.improvement_z;
    EXPECT_LT(z, 3.7);
    squares += z * z / 12.0;
  }
  EXPECT_LT(squares, 2.74);
}

}  // namespace
