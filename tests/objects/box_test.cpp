#include "objects/box.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numbers>

namespace {

using objects::Box;
constexpr double kPi = std::numbers::pi;

TEST(Box, LocalAndWorldAreInverse) {
  const Box box{.centre_m = {3, -2, 1}, .length_m = 4, .width_m = 2, .height_m = 1, .yaw_rad = 0.7};
  const objects::Vector3 there = box.toWorld({0.5, -1.5, 0.25});
  EXPECT_THAT(box.toLocal(there), testing::Pointwise(testing::DoubleNear(1e-14), {0.5, -1.5, 0.25}));
}

TEST(Box, LongerSideAheadTurnsByARightAngleAndKeepsTheRectangle) {
  const Box turned =
      objects::withLongerSideAhead({.centre_m = {5, 0, 0}, .length_m = 1.8, .width_m = 4.5, .yaw_rad = 0.1});
  EXPECT_EQ(turned.length_m, 4.5);
  EXPECT_EQ(turned.width_m, 1.8);
  EXPECT_NEAR(turned.yaw_rad, 0.1 - kPi / 2, 1e-15);  // 0.1 + 90° is beyond 90°, so it looks the other way
  EXPECT_EQ(objects::withLongerSideAhead({.length_m = 2, .yaw_rad = -kPi / 2}).yaw_rad, kPi / 2);
}

// A board 10 m ahead, seen as a line across: it grows away from the sensor, its face stays at 10 m.
TEST(Box, GrowsAwayFromTheSensor) {
  const Box board{.centre_m = {10, 0, 0}, .length_m = 0.0, .width_m = 2.0, .height_m = 1.0};
  const Box grown = atLeast(board, {0.5, 0.8, 2.0});
  EXPECT_EQ(grown.length_m, 0.5);
  EXPECT_EQ(grown.width_m, 2.0);
  EXPECT_EQ(grown.height_m, 2.0);
  EXPECT_DOUBLE_EQ(grown.centre_m[0], 10.25);
  EXPECT_EQ(grown.centre_m[2], 0.0);
  const Box behind = objects::atLeast({.centre_m = {-10, 0, 0}, .width_m = 2.0}, {0.5, 0.0, 0.0});
  EXPECT_DOUBLE_EQ(behind.centre_m[0], -10.25);
}

// The sensor looks straight at a narrow post: both of its edges are seen, so it grows to both sides.
TEST(Box, GrowsToBothSidesWhereBothEndsAreSeen) {
  const Box post = objects::atLeast({.centre_m = {10, 0, 0}, .length_m = 1.0, .width_m = 0.1}, {0.0, 0.5, 0.0});
  EXPECT_EQ(post.width_m, 0.5);
  EXPECT_EQ(post.centre_m[1], 0.0);
}

TEST(Box, LargeEnoughBoxesStayAsTheyAre) {
  const Box box{.centre_m = {8, 3, 0}, .length_m = 4, .width_m = 2, .height_m = 1, .yaw_rad = 0.3};
  EXPECT_EQ(atLeast(box, {0.8, 0.5, 0.0}), box);
}

}  // namespace
