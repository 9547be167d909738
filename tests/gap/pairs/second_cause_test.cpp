#include "gap/pairs/second_cause.h"

#include <gtest/gtest.h>

#include "gap/candidates/significance.h"
#include "gap/far/how_far.h"
#include "gap/pairs/partners.h"
#include "tests/gap/hypothesis_named.h"
#include "tests/gap/small_world.h"

namespace {

using test_support::SmallWorld;

// Dirt takes three quarters of the light in a sector, which is nearly all of the gap. An offset of 30 mm is a fiftieth
// of it, a gap beyond doubt by itself. Echo pulse widths that scatter more than anybody modelled keep a rest in either
// world.
TEST(SecondCause, NeedsNoLeastGainWhereItTakesNearlyAllThatAGiantLeaves) {
  const SmallWorld world;
  const SmallWorld::Effects dirt = {
      {"cover-contamination", {{"attenuation", 0.5}, {"azimuth_from_deg", -5.0}, {"azimuth_to_deg", 60.0}}}};
  SmallWorld::Effects both = dirt;
  both["range-offset"] = {{"offset_m", 0.03}};
  const auto measured = world.measuredBy(SmallWorld::modelWith(both, {{"/sensor/detection/epw_noise_m", 0.06}}), 0.4);
  const gap::Replay replay(measured, SmallWorld::modelWith({}));
  const gap::Split split = gap::splitOf(replay, 1);
  const gap::Judge judge{replay, split, gap::yardstickOf(replay, split.held_out)};
  const auto hypotheses = gap::hypothesesFor(replay, {"cover-contamination", "range-offset"});
  const auto candidate = [&](const std::string& name, std::vector<double> values) {
    return gap::Candidate{.hypothesis = test_support::hypothesisNamed(hypotheses, name), .values = std::move(values)};
  };
  gap::Candidate single = candidate("cover-contamination", {0.5, -5.0, 60.0});
  gap::Candidate pair = gap::pairOf(single, candidate("range-offset", {0.03}));
  for (gap::Candidate* heard : {&single, &pair}) judge.hear(*heard);
  single.total_left = 0.1;
  ASSERT_GT(single.explained, 0.95);
  ASSERT_GT(gap::deviationsLeft(judge, pair), gap::kNoRest);
  pair.total_left = 0.45 * single.total_left;  // not so little that it would be enough by itself
  EXPECT_TRUE(gap::earnsItsSecond(judge, judge, single, gap::deviationsLeft(judge, single), pair))
      << single.explained << " " << pair.explained;
  // What changes nothing where all data are pooled may be how two programs differ.
  pair.total_left = single.total_left;
  EXPECT_FALSE(gap::earnsItsSecond(judge, judge, single, gap::deviationsLeft(judge, single), pair));
  // A cause that is wrong in every cell may make up for how two programs differ where all data are pooled. Two that
  // leave next to nothing of the cells need not do that as well.
  single.explained = 0.5;
  single.total_left = 0.0;
  pair.total_left = 0.26;
  pair.explained = 0.96;
  EXPECT_TRUE(gap::earnsItsSecond(judge, judge, single, gap::deviationsLeft(judge, single), pair));
  pair.explained = 0.94;
  EXPECT_FALSE(gap::earnsItsSecond(judge, judge, single, gap::deviationsLeft(judge, single), pair));
}

/// An offset of 30 mm is all that is missing.
class MissingOffset : public testing::Test {
 protected:
  [[nodiscard]] gap::Candidate candidate(const std::string& name, double value) const {
    return {.hypothesis = test_support::hypothesisNamed(hypotheses_, name), .values = {value}};
  }

  SmallWorld world_;
  model::Experiment measured_ = world_.measuredBy(SmallWorld::modelWith({{"range-offset", {{"offset_m", 0.03}}}}), 0.4);
  gap::Replay replay_{measured_, SmallWorld::modelWith({})};
  gap::Split split_ = gap::splitOf(replay_, 1);
  gap::Judge judge_{replay_, split_, gap::yardstickOf(replay_, split_.held_out)};
  std::vector<gap::Hypothesis> hypotheses_ = gap::hypothesesFor(replay_, {"echo-merging", "range-offset"});
};

// Rare echoes show in no cell, but all of them together in the total gap.
TEST_F(MissingOffset, LeavesRoomForASecondCauseOnlyWhereAFifthOfTheTotalGapIsLeft) {
  gap::Candidate right = candidate("range-offset", 0.03);
  judge_.hear(right);
  ASSERT_LT(gap::deviationsLeft(judge_, right), gap::kNoRest);
  right.total_left = 0.25;
  EXPECT_TRUE(gap::roomForASecond(judge_, right, gap::deviationsLeft(judge_, right)));
  right.total_left = 0.1;
  EXPECT_FALSE(gap::roomForASecond(judge_, right, gap::deviationsLeft(judge_, right)));
}

TEST_F(MissingOffset, IsTheBetterMemberBesideACauseThatDoesNothing) {
  const gap::HeldOutGaps gaps(replay_, split_.held_out.samples, 1);
  const gap::Candidate pair = gap::pairOf(candidate("echo-merging", 1.0), candidate("range-offset", 0.03));
  const gap::Candidate member = gap::betterMember(judge_, gaps, pair);
  EXPECT_EQ(member.hypothesis.name, "range-offset");
  EXPECT_GT(member.explained, 0.9);
  EXPECT_LT(member.total_left, 0.1);
}

TEST_F(MissingOffset, DoesAsWellAloneAsBesideACauseThatDoesNothing) {
  gap::Candidate offset = candidate("range-offset", 0.03), merging = candidate("echo-merging", 1.0);
  gap::Candidate pair = gap::pairOf(merging, offset);
  for (gap::Candidate* heard : {&offset, &merging, &pair}) judge_.hear(*heard);
  EXPECT_TRUE(gap::doesAsWellAlone(judge_, judge_, offset, pair));
  EXPECT_FALSE(gap::doesAsWellAlone(judge_, judge_, merging, pair));
}

// Fog behind a wrong power is two numbers; a cloud that stands in for them is four, and which of sixty causes the
// second one is costs another.
TEST(SecondCause, NeedsNoGainBesideACauseThatSaysMoreThanBoth) {
  const SmallWorld world;
  const SmallWorld::Effects fog = {{"atmospheric-attenuation", {{"visibility_m", 1500.0}}}};
  const auto measured = world.measuredBy(SmallWorld::modelWith(fog, {{"/sensor/emitter/peak_power_w", 55.0}}), 0.4);
  const gap::Replay replay(measured, SmallWorld::modelWith({}));
  const gap::Split split = gap::splitOf(replay, 1);
  const gap::Judge judge{replay, split, gap::yardstickOf(replay, split.held_out)};
  const auto hypotheses = gap::hypothesesFor(replay, {});
  const auto candidate = [&](const std::string& name, std::vector<double> values) {
    gap::Candidate of{.hypothesis = test_support::hypothesisNamed(hypotheses, name), .values = std::move(values)};
    of.total_left = 0.6;
    return of;
  };
  // A third of the way, so that the pair halves nothing.
  gap::Candidate pair =
      gap::pairOf(candidate("atmospheric-attenuation", {4500.0}), candidate("/sensor/emitter/peak_power_w", {51.5}));
  pair.total_left = 0.6;
  gap::Candidate cloud = candidate("exhaust-cloud", {0.001, 0.5, 4.0, 0.0});
  gap::Candidate dirt = candidate("cover-contamination", {0.002, -5.0, 5.0});
  for (gap::Candidate* heard : {&pair, &cloud, &dirt}) judge.hear(*heard);
  ASSERT_LT(pair.explained, 0.5);
  const auto earns = [&](const gap::Candidate& single) {
    return gap::earnsItsSecond(judge, judge, single, gap::deviationsLeft(judge, single), pair);
  };
  EXPECT_TRUE(earns(cloud)) << pair.explained << " " << cloud.explained;
  EXPECT_FALSE(earns(dirt)) << pair.explained << " " << dirt.explained;
  pair.total_left = 0.7;
  EXPECT_FALSE(earns(cloud)) << "the total gap grows";
}

/// Speckle of ten looks, whose own noise is larger than all that a haze does.
class BesideSpeckle : public testing::Test {
 protected:
  [[nodiscard]] bool proves(double visibility_m, const SmallWorld::Effects& truth) const {
    const auto measured = world_.measuredBy(SmallWorld::modelWith(truth), 0.4);
    const gap::Replay replay(measured, SmallWorld::modelWith({}));
    const gap::Split split = gap::splitOf(replay, 1);
    const gap::Judge judge{replay, split, gap::yardstickOf(replay, split.held_out)};
    const auto hypotheses = gap::hypothesesFor(replay, {"speckle", "atmospheric-attenuation"});
    const auto candidate = [&](const std::string& name, double value) {
      return gap::Candidate{.hypothesis = test_support::hypothesisNamed(hypotheses, name), .values = {value}};
    };
    gap::Candidate single = candidate("speckle", 10.0);
    gap::Candidate pair = gap::pairOf(single, candidate("atmospheric-attenuation", visibility_m));
    for (gap::Candidate* heard : {&single, &pair}) judge.hear(*heard);
    single.total_left = pair.total_left = 0.0;
    EXPECT_FALSE(gap::roomForASecond(judge, single, gap::deviationsLeft(judge, single)));
    return gap::SecondProofs(judge, single, hypotheses.size()).of(pair);
  }

  SmallWorld world_;
  const SmallWorld::Effects speckle_ = {{"speckle", {{"looks", 10.0}}}};
  const SmallWorld::Effects both_ = {{"speckle", {{"looks", 10.0}}},
                                     {"atmospheric-attenuation", {{"visibility_m", 4000.0}}}};
};

TEST_F(BesideSpeckle, AHazeProvesItselfThoughNoRestShowsIt) { EXPECT_TRUE(proves(4000.0, both_)); }

TEST_F(BesideSpeckle, NothingProvesItselfThatIsNotThere) { EXPECT_FALSE(proves(20000.0, speckle_)); }

// It still brings the data nearer, but not by what it would bring if it were right: it may stand in for another cause.
TEST_F(BesideSpeckle, ACauseThatBringsHalfOfWhatItShouldDoesNotProveItself) { EXPECT_FALSE(proves(2500.0, both_)); }

}  // namespace
