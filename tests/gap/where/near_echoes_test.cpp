#include "gap/where/near_echoes.h"

#include <gtest/gtest.h>

#include "gap/where/end_of_loss.h"
#include "gap/where/where.h"
#include "tests/gap/small_world.h"

namespace {

using test_support::SmallWorld;

TEST(EndOfLoss, LiesHalfwayBetweenWhatIsLostAndWhatIsThere) {
  EXPECT_DOUBLE_EQ(gap::endOfLoss({{1.0, 5.0}, {2.0, 4.0}, {4.0, -6.0}}).value(), 3.0);
}

// Few that are there do not end the loss where more are lost beyond them.
TEST(EndOfLoss, IsWhereMostIsLostInAll) {
  EXPECT_DOUBLE_EQ(gap::endOfLoss({{1.0, 5.0}, {2.0, -1.0}, {4.0, 3.0}, {6.0, -9.0}}).value(), 5.0);
}

TEST(EndOfLoss, IsAtTheLastWhereAllIsLostAndNowhereWhereMoreIsThere) {
  EXPECT_DOUBLE_EQ(gap::endOfLoss({{1.0, 5.0}, {2.0, 4.0}}).value(), 2.0);
  EXPECT_FALSE(gap::endOfLoss({{1.0, -5.0}, {2.0, 4.0}}));
  EXPECT_FALSE(gap::endOfLoss({}));
}

/// Walls stand 3, 8, 14, 22, 31 and 41 m behind a pane. Within which distance of two surfaces echoes seem to be lost.
gap::NearEchoes lossOf(SmallWorld::Effects truth, const char* range_mode = "peak") {
  SmallWorld world;
  world.behindAPane(5.0);
  const SmallWorld::Effects known = {{"transmission", nlohmann::json::object()}};
  truth.insert(known.begin(), known.end());
  const auto reporting = [&](const SmallWorld::Effects& effects) {
    auto json = SmallWorld::modelWith(effects).json;
    json["sensor"]["detection"]["range_mode"] = range_mode;
    return model::parseModel(json, "model.json");
  };
  const auto measured = world.measuredBy(reporting(truth), 0.4);
  const gap::Replay replay(measured, reporting(known));
  return gap::whereIn(replay, replay.baseline(), 1).near_echoes;
}

TEST(NearEchoes, AreNotLostWhereNothingIsMissing) { EXPECT_FALSE(lossOf({}).within_m); }

// 70 ns are 10.49 m of way to and fro. In a beam 20° aside the surfaces are 6 % farther apart.
TEST(NearEchoes, AreLostWithinWhatADeadTimeCovers) {
  const auto within_m = lossOf({{"dead-time", {{"dead_time_ns", 70.0}}}}).within_m;
  ASSERT_TRUE(within_m);
  EXPECT_GT(*within_m, 8.0 * 1.06);
  EXPECT_LT(*within_m, 14.0);
}

// The pane sends back more than the wall behind it, and its leading edge is farther before its peak: by their ranges
// the two are 2 cm farther apart.
TEST(NearEchoes, AreLostWithinTheDistanceOfTheirPeaksAtWhichTheyMerge) {
  for (const char* const range_mode : {"peak", "leading-edge"}) {
    const gap::NearEchoes lost = lossOf({{"echo-merging", {{"separation_m", 3.05}}}}, range_mode);
    ASSERT_TRUE(lost.within_m && lost.peaks_within_m) << range_mode;
    EXPECT_NEAR(*lost.peaks_within_m, 3.05, 0.03);  // beams at 9° and 11° see surfaces 3.04 and 3.06 m apart
    if (range_mode == std::string("peak")) {
      EXPECT_DOUBLE_EQ(*lost.within_m, *lost.peaks_within_m);
    } else {
      EXPECT_NEAR(*lost.within_m - *lost.peaks_within_m, 0.02, 0.01);
    }
  }
}

}  // namespace
