#include "metrics/grids/map_score.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "tests/metrics/grids/random_grids.h"
#include "tests/support/thrown_message.h"

namespace {

using metrics::kUsualClip;
using metrics::mapScore;
using metrics::mapScorePerCell;
using metrics_test::grid;
using metrics_test::inverse;
using metrics_test::RandomGrids;
using metrics_test::TwoGrids;
using test_support::thrownMessage;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

TwoGrids cell(double simulated, double measured) {
  return {.simulated = grid(1, 1, {simulated}), .measured = grid(1, 1, {measured})};
}

// p / 2 + (1 - p) / 2 is 1/2: log2 is -1.
TEST(MapScore, OfAnUnknownCellIsZeroWhateverTheOtherSays) {
  for (const double p : {0.0, 0.2, 0.5, 0.9, 1.0}) {
    EXPECT_NEAR(mapScore(cell(p, 0.5).pair()), 0.0, 1e-15);
    EXPECT_NEAR(mapScore(cell(0.5, p).pair()), 0.0, 1e-15);
  }
}

TEST(MapScore, OfCertainCellsIsOneBitEachWhereTheyAgree) {
  const TwoGrids both = {.simulated = grid(2, 2, {0.0, 1.0, 1.0, 0.0}), .measured = grid(2, 2, {0.0, 1.0, 1.0, 0.0})};
  EXPECT_EQ(mapScore(both.pair(), 0.0), 4.0);
  EXPECT_EQ(mapScorePerCell(both.pair(), 0.0), 1.0);
}

TEST(MapScore, FollowsItsFormula) {
  EXPECT_DOUBLE_EQ(mapScore(cell(0.75, 1.0).pair(), 0.0), 1.0 + std::log2(0.75));
  EXPECT_DOUBLE_EQ(mapScore(cell(0.75, 0.25).pair()), 1.0 + std::log2(0.1875 + 0.1875));
}

TEST(MapScore, OfCertainCellsThatDifferIsLimitedByTheClipOnly) {
  EXPECT_EQ(mapScore(cell(1.0, 0.0).pair(), 0.0), -kInfinite);
  EXPECT_DOUBLE_EQ(mapScore(cell(1.0, 0.0).pair()), 1.0 + std::log2(2.0 * kUsualClip * (1.0 - kUsualClip)));
  EXPECT_NEAR(mapScore(cell(1.0, 0.0).pair()), -7.97, 0.005);
  EXPECT_DOUBLE_EQ(mapScore(cell(1.0, 0.0).pair(), 0.25), 1.0 + std::log2(2.0 * 0.25 * 0.75));
}

TEST(MapScore, WithImpossibleCellsStaysMinusInfinity) {
  const TwoGrids both = {.simulated = grid(1, 4, {1.0, 1.0, 0.3, 0.0}), .measured = grid(1, 4, {0.0, 1.0, 0.4, 1.0})};
  EXPECT_EQ(mapScore(both.pair(), 0.0), -kInfinite);
  EXPECT_TRUE(std::isfinite(mapScore(both.pair())));
}

TEST(MapScore, RewardsCertaintyRatherThanEquality) {
  EXPECT_GT(mapScore(cell(1.0, 0.6).pair()), mapScore(cell(0.6, 0.6).pair()));
}

TEST(MapScore, IsSymmetricAndUnchangedIfFreeAndOccupiedAreExchanged) {
  RandomGrids cases(221);
  for (int k = 0; k < 100; ++k) {
    const TwoGrids both = cases.two();
    EXPECT_EQ(mapScore(both.pair()), mapScore(both.exchanged()));
    EXPECT_NEAR(mapScore(both.pair()), mapScore(inverse(both).pair()), 1e-11);
  }
}

TEST(MapScore, RefusesAClipThatLeavesNoCertainty) {
  for (const double clip : {-0.1, 0.5, std::nan("")}) {
    EXPECT_NE(thrownMessage([&] { (void)mapScore(cell(0.1, 0.1).pair(), clip); }).find("clip of the map score"),
              std::string::npos);
  }
}

}  // namespace
