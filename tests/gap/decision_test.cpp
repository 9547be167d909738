#include "gap/decision.h"

#include <gtest/gtest.h>

namespace gap {
namespace {

TEST(TotalGap, MayStayAsLargeWhereAllCellsAgreeOrTheCausesOwnNoiseIsLeft) {
  const auto left = [](double explained, double total_left) {
    return Candidate{.explained = explained, .total_left = total_left};
  };
  EXPECT_TRUE(holdsOnTotal(left(0.8, 0.9), 0.1));
  EXPECT_FALSE(holdsOnTotal(left(0.8, 0.9), -0.1)) << "fitted single cells only";
  EXPECT_TRUE(holdsOnTotal(left(0.96, 0.9), -0.1));
  EXPECT_TRUE(holdsOnTotal(left(0.8, 0.4), -0.1)) << "rare false alarms";
}

}  // namespace
}  // namespace gap
