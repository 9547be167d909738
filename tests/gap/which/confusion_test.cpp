#include "gap/which/confusion.h"

#include <gtest/gtest.h>

#include "gap/candidates/candidates.h"
#include "tests/gap/small_world.h"

namespace {

using test_support::SmallWorld;

/// Worlds over the small experiment: fog of some visibility, an offset of the range.
class ConfusionTest : public testing::Test {
 protected:
  static gap::NamedWorld named(const std::string& name, const SmallWorld::Effects& effects) {
    return {name, {SmallWorld::modelWith(effects), {}, {}}};
  }
  static gap::NamedWorld fog(const std::string& name, double visibility_m) {
    return named(name, {{"atmospheric-attenuation", {{"visibility_m", visibility_m}}}});
  }

  SmallWorld world_;
  model::LidarModel model_ = SmallWorld::modelWith({});
  model::Experiment experiment_ = world_.measuredBy(model_, 0.4);
  gap::Replay replay_{experiment_, model_};
  gap::Evidence held_out_ = gap::splitOf(replay_, 1).held_out;
};

TEST_F(ConfusionTest, IsSymmetricOneOnTheDiagonalAndNeverBeyondZeroAndOne) {
  const auto confusion = gap::confusionOf(
      replay_, {fog("a", 400), named("b", {{"range-offset", {{"offset_m", 0.08}}}}), fog("c", 900)}, held_out_);
  ASSERT_EQ(confusion.names, (std::vector<std::string>{"a", "b", "c"}));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(confusion.alike[i][i], 1.0);
    for (std::size_t j = 0; j < 3; ++j) {
      EXPECT_EQ(confusion.alike[i][j], confusion.alike[j][i]);
      EXPECT_GE(confusion.alike[i][j], 0.0);
      EXPECT_LE(confusion.alike[i][j], 1.0);
    }
  }
}

// The same world under two names differs by noise only, and the noise is taken off.
TEST_F(ConfusionTest, IsNearOneForTwoAccountsOfTheSameWorld) {
  const auto confusion = gap::confusionOf(replay_, {fog("one", 400), fog("other", 400)}, held_out_);
  EXPECT_GT(confusion.alike[0][1], 0.97);
}

// Fog weakens echoes and leaves ranges alone (peak detection); an offset moves ranges and nothing else. What they do to
// the cells adds up, so they are farther from each other than either from the baseline.
TEST_F(ConfusionTest, IsNearZeroForEffectsThatChangeDifferentMeasurands) {
  const auto confusion = gap::confusionOf(
      replay_, {fog("fog", 400), named("offset", {{"range-offset", {{"offset_m", 0.08}}}})}, held_out_);
  EXPECT_LT(confusion.alike[0][1], 0.1);
}

TEST_F(ConfusionTest, SurvivesNoCauses) { EXPECT_TRUE(gap::confusionOf(replay_, {}, held_out_).alike.empty()); }

// An offset of 0.08 m moves every range by 0.08 m: that is what the prediction must say, and nothing of the EPW.
TEST_F(ConfusionTest, PredictsTheRangesOfAnOffset) {
  const auto predictions = gap::predictionsOf(
      replay_,
      {replay_.baseline(), replay_.baseline(), named("offset", {{"range-offset", {{"offset_m", 0.08}}}}).world}, 0, 1);
  ASSERT_EQ(predictions.size(), 1U);
  EXPECT_EQ(predictions[0].measurand, "range");
  EXPECT_NEAR(predictions[0].values[2] - predictions[0].values[1], 0.08, 0.01);
  EXPECT_EQ(predictions[0].values[0], predictions[0].values[1]);
}

TEST_F(ConfusionTest, PredictsNothingThatTellsTwoEqualWorldsApart) {
  EXPECT_TRUE(gap::predictionsOf(replay_, {replay_.baseline(), replay_.baseline(), replay_.baseline()}, 0, 1).empty());
}

}  // namespace
