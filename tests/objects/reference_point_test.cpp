#include "objects/reference_point.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numbers>

namespace {

using objects::Box;
using objects::ReferenceChoice;
using objects::ReferencePoint;
using objects::Vector3;
using testing::DoubleNear;
using testing::Pointwise;

constexpr double kPi = std::numbers::pi;
constexpr ReferencePoint kAll[] = {ReferencePoint::kCentre,     ReferencePoint::kFront,    ReferencePoint::kRear,
                                   ReferencePoint::kLeft,       ReferencePoint::kRight,    ReferencePoint::kFrontLeft,
                                   ReferencePoint::kFrontRight, ReferencePoint::kRearLeft, ReferencePoint::kRearRight,
                                   ReferencePoint::kRearAxle};

ReferenceChoice named(const std::string& name) { return *ReferenceChoice::named(name); }

// A car 4 m by 2 m at the origin looking along +y: its front is up there, its left is on the -x side.
TEST(ReferencePoint, LiesWhereItsNameSays) {
  const Box car{.centre_m = {0, 0, 1}, .length_m = 4, .width_m = 2, .height_m = 1.5, .yaw_rad = kPi / 2};
  const auto at = [&](ReferencePoint point) { return stateAt(car, point, {.rear_axle_share = 0.25}).position_m; };
  EXPECT_THAT(at(ReferencePoint::kCentre), Pointwise(DoubleNear(1e-15), {0.0, 0.0, 1.0}));
  EXPECT_THAT(at(ReferencePoint::kFront), Pointwise(DoubleNear(1e-15), {0.0, 2.0, 1.0}));
  EXPECT_THAT(at(ReferencePoint::kLeft), Pointwise(DoubleNear(1e-15), {-1.0, 0.0, 1.0}));
  EXPECT_THAT(at(ReferencePoint::kFrontLeft), Pointwise(DoubleNear(1e-15), {-1.0, 2.0, 1.0}));
  EXPECT_THAT(at(ReferencePoint::kRearRight), Pointwise(DoubleNear(1e-15), {1.0, -2.0, 1.0}));
  EXPECT_THAT(at(ReferencePoint::kRearAxle), Pointwise(DoubleNear(1e-15), {0.0, -1.0, 1.0}));
}

TEST(ReferencePoint, ConversionsAreInvertible) {
  const Box box{.centre_m = {12, -7, 0.4}, .length_m = 4.5, .width_m = 1.8, .height_m = 1.5, .yaw_rad = -2.1};
  for (const ReferencePoint from : kAll) {
    for (const ReferencePoint to : kAll) {
      const objects::ObjectState there = converted(stateAt(box, from), to);
      EXPECT_EQ(there.point, to);
      EXPECT_THAT(boxOf(there).centre_m, Pointwise(DoubleNear(1e-14), box.centre_m)) << toString(from) << toString(to);
    }
  }
}

TEST(ReferencePoint, AllAreOneAtZeroSize) {
  const Box dot{.centre_m = {12, -7, 0.4}, .yaw_rad = 0.8};
  for (const ReferencePoint point : kAll) EXPECT_EQ(stateAt(dot, point).position_m, dot.centre_m) << toString(point);
}

// Ahead and to the left, heading like the ego: the sensor sees the rear and the right side.
TEST(ReferencePoint, NearestIsWhatTheSensorSees) {
  const Box car{.centre_m = {20, 5, 0}, .length_m = 4, .width_m = 2};
  EXPECT_EQ(nearestCorner(car), ReferencePoint::kRearRight);
  EXPECT_EQ(nearestSide(car), ReferencePoint::kRear);
  const Box turned{.centre_m = {20, 5, 0}, .length_m = 4, .width_m = 2, .yaw_rad = kPi};
  EXPECT_EQ(nearestCorner(turned), ReferencePoint::kFrontLeft);
  EXPECT_EQ(named("nearest-corner").on(turned), ReferencePoint::kFrontLeft);
}

// The reason for all this: a car whose far end is not seen is too short by 1 m. Its near corner is right, its centre is
// off by half of the missing metre.
TEST(ReferencePoint, AShortBoxIsOffAtTheCentreAndRightAtTheNearCorner) {
  const Box car{.centre_m = {20, 5, 0}, .length_m = 4, .width_m = 2};
  const Box seen{.centre_m = {19.5, 5, 0}, .length_m = 3, .width_m = 2};
  EXPECT_THAT(positionError(seen, car, named("centre")), Pointwise(DoubleNear(1e-14), {-0.5, 0.0, 0.0}));
  EXPECT_THAT(positionError(seen, car, named("nearest-corner")), Pointwise(DoubleNear(1e-14), {0.0, 0.0, 0.0}));
  EXPECT_THAT(positionError(seen, car, named("nearest-side")), Pointwise(DoubleNear(1e-14), {0.0, 0.0, 0.0}));
  EXPECT_THAT(positionError(seen, car, named("front")), Pointwise(DoubleNear(1e-14), {-1.0, 0.0, 0.0}));
}

// Which end of a parked car is its front cannot be seen. The same rectangle has no error, however it is described.
TEST(ReferencePoint, ATurnedDescriptionOfTheSameRectangleHasNoError) {
  const Box car{.centre_m = {20, 5, 0}, .length_m = 4, .width_m = 2, .yaw_rad = 0.3};
  Box backwards = car;
  backwards.yaw_rad += kPi;
  const Box sideways{.centre_m = car.centre_m, .length_m = 2, .width_m = 4, .yaw_rad = 0.3 + kPi / 2};
  for (const char* name : {"centre", "nearest-corner", "nearest-side", "front", "rear-left"}) {
    for (const Box& same : {backwards, sideways}) {
      EXPECT_THAT(positionError(same, car, named(name)), Pointwise(DoubleNear(1e-13), {0.0, 0.0, 0.0})) << name;
    }
  }
  EXPECT_NEAR(yawError(backwards, car), 0.0, 1e-15);
}

TEST(ReferencePoint, EveryNameIsKnownAndNoOther) {
  EXPECT_EQ(ReferenceChoice::names().size(), 12u);
  for (const std::string& name : ReferenceChoice::names()) EXPECT_TRUE(ReferenceChoice::named(name)) << name;
  EXPECT_FALSE(ReferenceChoice::named("bumper"));
}

}  // namespace
