#include "gap/pairs/untouched.h"

#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

#include "gap/pairs/second_cause.h"
#include "tests/gap/small_world.h"
#include "tests/gap/usual_causes.h"

namespace {

using test_support::SmallWorld;

/// What one cause leaves untouched of a measurement that it and others made.
class BesideACause {
 public:
  /// The world lives longer.
  BesideACause(const SmallWorld& world, const SmallWorld::Effects& truth)
      : measured_(world.measuredBy(SmallWorld::modelWith(truth), 0.4)) {}

  [[nodiscard]] gap::Aspects untouchedBy(const std::string& name, const std::vector<double>& values) const {
    return gap::untouchedBy(judge_, knownAs(name, values));
  }
  [[nodiscard]] bool missesSomethingBeside(const std::string& name, const std::vector<double>& values) const {
    return gap::WhereUntouched(judge_, knownAs(name, values)).missesSomething();
  }
  [[nodiscard]] std::vector<gap::Candidate> pairsWith(const std::string& name, const std::vector<double>& values) {
    return gap::WhereUntouched(judge_, knownAs(name, values)).pairs(judge_, singles_, progress_);
  }

  /// Of whose total gap a third is left.
  [[nodiscard]] gap::Candidate heard(const std::string& name, const std::vector<double>& values) const {
    gap::Candidate candidate = knownAs(name, values);
    judge_.hear(candidate);
    candidate.total_left = 1.0 / 3.0;
    return candidate;
  }
  [[nodiscard]] const gap::Judge& judge() const { return judge_; }

 private:
  [[nodiscard]] gap::Candidate knownAs(const std::string& name, const std::vector<double>& values) const {
    return test_support::causeNamed(singles_, name, values);
  }

  model::Experiment measured_;
  gap::Replay replay_{measured_, SmallWorld::modelWith({})};
  gap::Split split_ = gap::splitOf(replay_, 1);
  gap::Judge judge_{replay_, split_, gap::yardstickOf(replay_, split_.held_out)};
  std::vector<gap::Candidate> singles_ = test_support::usualCauses(replay_);
  core::SilentProgress progress_;
};

const SmallWorld::Effects kSteps = {{"quantisation", {{"range_step_m", 0.2}}}};
const SmallWorld::Effects kStepsAndDirt = {{"quantisation", {{"range_step_m", 0.2}}},
                                           {"cover-contamination", {{"attenuation", 0.02}}}};

TEST(Untouched, StepsOfTheRangeTouchNothingElse) {
  const SmallWorld world;
  const gap::Aspects untouched = BesideACause(world, kSteps).untouchedBy("quantisation", {0.2});
  EXPECT_FALSE(untouched.means[gap::kRange]);
  EXPECT_TRUE(untouched.means[gap::kIntensity]);
  EXPECT_TRUE(untouched.spreads[gap::kIntensity]);
  EXPECT_TRUE(untouched.means[gap::kEpw]);
}

TEST(Untouched, DirtLeavesRangesAlone) {
  const SmallWorld world;
  const gap::Aspects untouched =
      BesideACause(world, kStepsAndDirt).untouchedBy("cover-contamination", {0.3, -60.0, 60.0});
  EXPECT_TRUE(untouched.means[gap::kRange]);
  EXPECT_FALSE(untouched.means[gap::kIntensity]);
}

// Steps leave so much of the ranges that two per cent of the light are nothing beside it.
TEST(Untouched, WhatDimsTheLightIsFoundBehindSteps) {
  const SmallWorld world;
  BesideACause search(world, kStepsAndDirt);
  const auto pairs = search.pairsWith("quantisation", {0.2});
  ASSERT_FALSE(pairs.empty());
  EXPECT_GT(pairs.front().explained, 0.9);
  for (const gap::Candidate& pair : pairs) EXPECT_EQ(pair.hypothesis.members.front().name, "quantisation");
}

// Pooled data count edges, which programs differ in; but what makes all of the total gap anew is no cause.
TEST(Untouched, WhatLeavesNothingThereMayLeaveMoreOfTheTotalGapButNotAllOfIt) {
  const SmallWorld world;
  BesideACause search(world, kStepsAndDirt);
  const gap::Candidate steps = search.heard("quantisation", {0.2});
  auto pairs = search.pairsWith("quantisation", {0.2});
  ASSERT_FALSE(pairs.empty());
  gap::Candidate& pair = pairs.front();
  const auto earns = [&](double total_left, bool nothing_left_there) {
    pair.total_left = total_left;
    return gap::earnsItsSecondElsewhere(search.judge(), search.judge(), steps, pair, nothing_left_there);
  };
  EXPECT_TRUE(earns(steps.total_left, false));
  EXPECT_FALSE(earns(steps.total_left + 0.3, false));
  EXPECT_TRUE(earns(steps.total_left + 0.3, true));
  EXPECT_FALSE(earns(1.1, true));
}

TEST(Untouched, NothingIsMissedWhereOneCauseIsAllThereIs) {
  const SmallWorld world;
  BesideACause search(world, kSteps);
  EXPECT_FALSE(search.missesSomethingBeside("quantisation", {0.2}));
}

}  // namespace
