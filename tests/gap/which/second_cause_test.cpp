#include "gap/which/second_cause.h"

#include <gtest/gtest.h>

#include "gap/which/partners.h"
#include "gap/which/significance.h"
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
  ASSERT_GT(gap::restOf(judge, pair), gap::kNoRest);
  pair.total_left = 0.45 * single.total_left;  // not so little that it would be enough by itself
  EXPECT_TRUE(gap::earnsItsSecond(judge, judge, single, pair)) << single.explained << " " << pair.explained;
  // What changes nothing where all data are pooled may be how two programs differ.
  pair.total_left = single.total_left;
  EXPECT_FALSE(gap::earnsItsSecond(judge, judge, single, pair));
}

// Rare echoes show in no cell, but all of them together in the total gap.
TEST(SecondCause, IsLookedForWhereAFifthOfTheTotalGapIsLeftThoughNoCellShowsIt) {
  const SmallWorld world;
  const auto measured = world.measuredBy(SmallWorld::modelWith({{"range-offset", {{"offset_m", 0.03}}}}), 0.4);
  const gap::Replay replay(measured, SmallWorld::modelWith({}));
  const gap::Split split = gap::splitOf(replay, 1);
  const gap::Judge judge{replay, split, gap::yardstickOf(replay, split.held_out)};
  gap::Candidate right{
      .hypothesis = test_support::hypothesisNamed(gap::hypothesesFor(replay, {"range-offset"}), "range-offset"),
      .values = {0.03}};
  judge.hear(right);
  ASSERT_LT(gap::restOf(judge, right), gap::kNoRest);
  right.total_left = 0.25;
  EXPECT_TRUE(gap::roomForASecond(judge, right));
  right.total_left = 0.1;
  EXPECT_FALSE(gap::roomForASecond(judge, right));
}

}  // namespace
