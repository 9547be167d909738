#include "gap/verdict.h"

#include <gtest/gtest.h>

#include "tests/gap/small_world.h"

namespace {

using test_support::SmallWorld;

/// What `none` is believed with where the gap stands so many standard deviations of noise above a right model's.
double confidenceOfNone(double z) {
  const SmallWorld world;
  const auto model = SmallWorld::modelWith({});
  const auto measured = world.measuredBy(model, 0.4);
  const gap::Replay replay(measured, model);
  gap::Yardstick yardstick;
  yardstick.perfect = 100.0;
  yardstick.perfect_spread = 10.0;
  yardstick.baseline = 100.0 + 10.0 * z;
  const gap::Judge judge{replay, gap::splitOf(replay, 1), yardstick};
  gap::Decision decision;
  decision.kind = gap::VerdictKind::kNone;
  gap::Diagnosis diagnosis;
  gap::fillVerdict(judge, decision, diagnosis);
  return diagnosis.verdict.confidence;
}

// Beyond that the test of whether there is a gap has spoken: what it calls none there is too small to matter.
TEST(Verdict, ThatNothingIsMissingIsDoubtedWhereNoiseHardlyEverMakesSuchAGap) {
  const double sure = confidenceOfNone(0.0);
  EXPECT_DOUBLE_EQ(confidenceOfNone(-2.0), sure);
  EXPECT_DOUBLE_EQ(confidenceOfNone(1.5), sure);
  EXPECT_LT(confidenceOfNone(3.0), 0.5);
  EXPECT_DOUBLE_EQ(confidenceOfNone(8.0), sure);
}

}  // namespace
