#include "objects/ground.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "core/random.h"

namespace {

using objects::fitGround;
using objects::Ground;
using objects::GroundPlane;
using objects::Vector3;

core::Random random(std::uint64_t seed = 1) { return core::Random({.seed = seed}); }

/// A square of ground with a wall of `wall` points on it.
std::vector<Vector3> groundAndWall(const GroundPlane& plane, int per_side, int wall) {
  std::vector<Vector3> points;
  for (int i = 0; i < per_side; ++i) {
    for (int j = 0; j < per_side; ++j) {
      const double x = 2.0 + i, y = j - per_side / 2.0;
      points.push_back({x, y, plane.at(x, y)});
    }
  }
  for (int i = 0; i < wall; ++i) points.push_back({10.0, 0.05 * i - 2.0, plane.at(10.0, 0.0) + 0.5 + 0.01 * i});
  return points;
}

// Without noise and with everything else out of tolerance, least squares give the plane itself.
TEST(FitGround, FindsTheExactPlaneAmongOtherPoints) {
  const GroundPlane plane{.slope_x = 0.02, .slope_y = -0.05, .height_m = -1.7};
  const auto found = fitGround(groundAndWall(plane, 20, 300), {}, random());
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->slope_x, plane.slope_x, 1e-12);
  EXPECT_NEAR(found->slope_y, plane.slope_y, 1e-12);
  EXPECT_NEAR(found->height_m, plane.height_m, 1e-11);
}

// 400 points with 3 cm of noise: heights of the plane are known to 0.03/20 = 1.5 mm in the middle; 5 sigma.
TEST(FitGround, NoiseIsAveraged) {
  core::Random noise({.seed = 3});
  const GroundPlane plane{.slope_x = 0.0, .slope_y = 0.01, .height_m = -1.0};
  std::vector<Vector3> points = groundAndWall(plane, 20, 100);
  for (Vector3& p : points) p[2] += 0.03 * noise.normal();
  const auto found = fitGround(points, {}, random());
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->at(11.5, -0.5), plane.at(11.5, -0.5), 0.0075);
}

// Rows of a scanner on a wall are lines: they hold many points near a level plane, but spread in one direction only.
TEST(FitGround, AWallIsNoGround) {
  std::vector<Vector3> points;
  for (int layer = 0; layer < 4; ++layer) {
    for (int i = 0; i < 100; ++i) points.push_back({20.0, 0.2 * i - 10.0, -0.4 * layer});
  }
  EXPECT_FALSE(fitGround(points, {}, random()));
}

TEST(FitGround, TooSteepTooHighTooFewOrTooScatteredIsNoGround) {
  EXPECT_FALSE(fitGround(groundAndWall({.slope_x = 0.5, .height_m = -1.7}, 20, 0), {}, random()));
  EXPECT_FALSE(fitGround(groundAndWall({.height_m = 1.0}, 20, 0), {}, random()));
  EXPECT_FALSE(fitGround(std::vector<Vector3>{{1, 0, -1}, {2, 0, -1}}, {}, random()));
  EXPECT_FALSE(fitGround(std::vector<Vector3>{}, {}, random()));
  std::vector<Vector3> same(50, Vector3{5, 0, -1});
  EXPECT_FALSE(fitGround(same, {}, random()));
}

TEST(FitGround, TheSameKeyGivesTheSamePlane) {
  core::Random noise({.seed = 3});
  std::vector<Vector3> points = groundAndWall({.height_m = -1.5}, 15, 100);
  for (Vector3& p : points) p[2] += 0.1 * noise.normal();
  const auto first = fitGround(points, {}, random(9)), second = fitGround(points, {}, random(9));
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->height_m, second->height_m);
  EXPECT_EQ(first->slope_x, second->slope_x);
}

model::SceneObject object(model::Shape shape, model::Pose pose) { return {.id = "o", .shape = shape, .pose = pose}; }

TEST(Ground, PlanesAndFlatRectanglesAreGroundByReference) {
  EXPECT_TRUE(objects::isGround(object(model::Plane{}, {})));
  EXPECT_TRUE(objects::isGround(object(model::Plane{}, {.roll_deg = 180})));
  EXPECT_FALSE(objects::isGround(object(model::Plane{}, {.pitch_deg = 90})));
  EXPECT_FALSE(objects::isGround(object(model::Rectangle{4, 4}, {})));
  EXPECT_TRUE(objects::isGround(object(model::Rectangle{4, 4}, {.pitch_deg = 90})));
  EXPECT_FALSE(objects::isGround(object(model::Box{{9, 9, 0.1}}, {})));
}

// A road of 4 m by 20 m, 1 m below the sensor: ground on it, none beside it.
TEST(Ground, ARectangleEndsAtItsEdges) {
  model::Scene scene;
  scene.objects.push_back(object(model::Rectangle{4, 20}, {.position_m = {10, 0, -1}, .pitch_deg = 90}));
  const Ground ground = objects::groundOf(scene);
  ASSERT_TRUE(ground.heightAt(15.0, 1.9));
  EXPECT_NEAR(*ground.heightAt(15.0, 1.9), -1.0, 1e-12);
  EXPECT_FALSE(ground.heightAt(15.0, 2.1));
  EXPECT_FALSE(ground.heightAt(20.1, 0.0));
}

TEST(Ground, WhatLiesOnOrBelowItIsGround) {
  Ground ground;
  ground.add({.height_m = -1.0});
  EXPECT_TRUE(isOnGround({5, 0, -1.0}, ground, 0.2));
  EXPECT_TRUE(isOnGround({5, 0, -0.81}, ground, 0.2));
  EXPECT_FALSE(isOnGround({5, 0, -0.79}, ground, 0.2));
  EXPECT_TRUE(isOnGround({5, 0, -3.0}, ground, 0.2));
  EXPECT_FALSE(isOnGround({5, 0, -3.0}, Ground(), 0.2));
}

}  // namespace
