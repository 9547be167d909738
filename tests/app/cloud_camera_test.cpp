#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

#include "app/desktop/cloud/camera.h"

namespace {

using desktop::Camera;
using desktop::Point3;

constexpr double kHalfPi = std::numbers::pi / 2;

Camera camera(double azimuth_rad, double down_rad) {
  Camera made;
  made.setViewport({800, 600});
  made.look(azimuth_rad, down_rad);
  made.lookAt({0, 0, 0});
  return made;
}

// ISO 8855: who looks along x has y, the left, on the left of the screen and z above.
TEST(Camera, LooksAlongXWithLeftOnTheLeft) {
  const Camera along_x = camera(0, 0);
  EXPECT_LT(along_x.project({0, 1, 0}).x, 400);
  EXPECT_NEAR(along_x.project({0, 1, 0}).y, 300, 1e-9);
  EXPECT_LT(along_x.project({0, 0, 1}).y, 300);
  EXPECT_GT(along_x.project({1, 0, 0}).depth, along_x.project({0, 0, 0}).depth);
}

TEST(Camera, FromAboveXIsUpAndYIsLeft) {
  const Camera above = camera(0, kHalfPi);
  EXPECT_NEAR(above.project({1, 0, 0}).x, 400, 1e-9);
  EXPECT_LT(above.project({1, 0, 0}).y, 300);
  EXPECT_LT(above.project({0, 1, 0}).x, 400);
}

// Size on the screen falls with 1 / depth; the target keeps pixelsPerMetre().
TEST(Camera, PerspectiveIsTheRuleOfThree) {
  const Camera eye = camera(0, 0);
  const auto here = eye.project({0, 1, 0});
  const auto behind = eye.project({10, 1, 0});
  EXPECT_NEAR(400 - here.x, eye.pixelsPerMetre(), 1e-9);
  EXPECT_NEAR((400 - here.x) * here.depth, (400 - behind.x) * behind.depth, 1e-6);
}

TEST(Camera, ParallelProjectionIsTrueToScaleAtEveryDepth) {
  Camera map = camera(0.3, 0.8);
  map.setParallel(true);
  const auto length = [&](Point3 from, Point3 to) {
    return std::hypot(map.project(from).x - map.project(to).x, map.project(from).y - map.project(to).y);
  };
  EXPECT_NEAR(length({0, 0, 0}, {0, 1, 0}), length({30, 5, 2}, {30, 6, 2}), 1e-6);
}

TEST(Camera, WhatIsUnderThePointerStaysThereWhileZooming) {
  Camera eye = camera(0.4, 0.6);
  eye.setParallel(true);
  const Point3 point{3, -2, 1};
  const auto before = eye.project(point);
  eye.zoom(2.5, {before.x, before.y});
  EXPECT_NEAR(eye.project(point).x, before.x, 1e-6);
  EXPECT_NEAR(eye.project(point).y, before.y, 1e-6);
  EXPECT_NEAR(eye.project({4, -2, 1}).x - before.x, 2.5 * (camera(0.4, 0.6).project({1, 0, 0}).x - 400), 25.0);
}

TEST(Camera, PanFollowsThePointer) {
  Camera eye = camera(-0.7, 0.3);
  eye.pan({40, -25});
  EXPECT_NEAR(eye.project({0, 0, 0}).x, 440, 1e-9);
  EXPECT_NEAR(eye.project({0, 0, 0}).y, 275, 1e-9);
}

TEST(Camera, FittedPointsAreAllInsideAndFillTheWindow) {
  std::vector<Point3> points;
  for (int corner = 0; corner < 8; ++corner) {
    points.push_back({corner & 1 ? 60.0 : 0.0, corner & 2 ? 25.0 : -10.0, corner & 4 ? 4.0 : -1.0});
  }
  for (const bool parallel : {false, true}) {
    for (const double down : {0.0, 0.5, kHalfPi}) {
      Camera eye = camera(-0.5, down);
      eye.setParallel(parallel);
      eye.fit(points);
      double widest = 0.0;
      for (const Point3& point : points) {
        const auto at = eye.project(point);
        EXPECT_TRUE(at.visible());
        EXPECT_TRUE(at.x >= 0 && at.x <= 800 && at.y >= 0 && at.y <= 600) << at.x << " " << at.y;
        widest = std::max({widest, std::abs(at.x - 400) / 400, std::abs(at.y - 300) / 300});
      }
      EXPECT_GT(widest, 0.8);
    }
  }
}

TEST(Camera, NeverGoesOverTheTop) {
  Camera eye = camera(0, 0);
  eye.orbit(0, 10);
  EXPECT_LT(eye.project({1, 0, 0}).y, 300);  // still from above, x up
  EXPECT_NEAR(eye.project({0, 0, 1}).y, 300, 1e-6);
}

}  // namespace
