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
std::optional<double> lossOf(SmallWorld::Effects truth) {
  SmallWorld world;
  world.behindAPane(5.0);
  const SmallWorld::Effects known = {{"transmission", nlohmann::json::object()}};
  truth.insert(known.begin(), known.end());
  const auto measured = world.measuredBy(SmallWorld::modelWith(truth), 0.4);
  const gap::Replay replay(measured, SmallWorld::modelWith(known));
  return gap::whereIn(replay, replay.baseline(), 1).near_echoes_m;
}

TEST(NearEchoes, AreNotLostWhereNothingIsMissing) { EXPECT_FALSE(lossOf({})); }

// 70 ns are 10.49 m of way to and fro. In a beam 20° aside the surfaces are 6 % farther apart.
TEST(NearEchoes, AreLostWithinWhatADeadTimeCovers) {
  const auto within_m = lossOf({{"dead-time", {{"dead_time_ns", 70.0}}}});
  ASSERT_TRUE(within_m);
  EXPECT_GT(*within_m, 8.0 * 1.06);
  EXPECT_LT(*within_m, 14.0);
}

TEST(NearEchoes, AreLostWithinTheDistanceAtWhichTheyMerge) {
  const auto within_m = lossOf({{"echo-merging", {{"separation_m", 3.05}}}});
  ASSERT_TRUE(within_m);
  EXPECT_NEAR(*within_m, 3.05, 0.03);  // beams at 9° and 11° see surfaces 3.04 and 3.06 m apart
}

}  // namespace
