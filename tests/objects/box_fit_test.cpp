#include "objects/box_fit.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <numeric>
#include <vector>

#include "core/physics.h"
#include "core/random.h"

namespace {

using core::kRadPerDeg;
using objects::Box;
using objects::BoxFit;
using objects::FitCriterion;
using objects::Vector3;

/// Points every `step` along the sides of a box that the sensor sees, ends included.
std::vector<Vector3> visibleSides(const Box& box, double step_m) {
  const Vector3 sensor = box.toLocal({0, 0, 0});
  std::vector<Vector3> points;
  const auto side = [&](double x0, double y0, double x1, double y1) {
    const int n = static_cast<int>(std::lround(std::hypot(x1 - x0, y1 - y0) / step_m));
    for (int i = 0; i <= n; ++i) {
      const double t = static_cast<double>(i) / n;
      points.push_back(box.toWorld({x0 + t * (x1 - x0), y0 + t * (y1 - y0), -box.height_m / 2}));
      points.push_back(box.toWorld({x0 + t * (x1 - x0), y0 + t * (y1 - y0), box.height_m / 2}));
    }
  };
  const double l = box.length_m / 2, w = box.width_m / 2;
  if (sensor[0] > l) side(l, -w, l, w);
  if (sensor[0] < -l) side(-l, -w, -l, w);
  if (sensor[1] > w) side(-l, w, l, w);
  if (sensor[1] < -w) side(-l, -w, l, -w);
  return points;
}

Box fitted(const std::vector<Vector3>& points, const BoxFit& options = {}) {
  std::vector<std::size_t> all(points.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return fitBox(points, all, options);
}

double turn(const Box& a, const Box& b) { return std::abs(std::remainder(a.yaw_rad - b.yaw_rad, std::numbers::pi)); }

// Two visible sides tell everything. Direction to half a step of the finer search (0.025°); it moves the ends of a side
// of 4.5 m by 2 mm.
TEST(BoxFit, ABoxSeenFromTwoSidesIsFoundAtAnyHeading) {
  for (const FitCriterion criterion : {FitCriterion::kArea, FitCriterion::kCloseness, FitCriterion::kVariance}) {
    for (int degrees = -89; degrees <= 90; degrees += 7) {
      // The sensor sees two sides of a car 15 m away whose diagonal points at it.
      const double yaw = degrees * kRadPerDeg, bearing = yaw + 0.6;
      const Box car{.centre_m = {15 * std::cos(bearing), 15 * std::sin(bearing), 0.2},
                    .length_m = 4.5,
                    .width_m = 1.8,
                    .height_m = 1.4,
                    .yaw_rad = yaw};
      const Box found = fitted(visibleSides(car, 0.05), {.criterion = criterion});
      EXPECT_LE(turn(found, car), 0.026 * kRadPerDeg) << degrees;
      EXPECT_NEAR(found.length_m, 4.5, 0.003) << degrees;
      EXPECT_NEAR(found.width_m, 1.8, 0.003) << degrees;
      EXPECT_NEAR(found.height_m, 1.4, 1e-12);
      for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found.centre_m[k], car.centre_m[k], 0.002) << degrees;
    }
  }
}

TEST(BoxFit, OneVisibleSideIsABoxWithoutWidth) {
  const Box board{.centre_m = {10, 0, 0}, .length_m = 0, .width_m = 2, .height_m = 1};
  const Box found = fitted(visibleSides({.centre_m = {10, 0, 0}, .length_m = 0.0, .width_m = 2, .height_m = 1}, 0.1));
  EXPECT_NEAR(found.length_m, 2.0, 1e-9);
  EXPECT_NEAR(found.width_m, 0.0, 1e-9);
  EXPECT_NEAR(found.yaw_rad, std::numbers::pi / 2, 1e-9);
  EXPECT_NEAR(found.centre_m[0], board.centre_m[0], 1e-9);
}

TEST(BoxFit, OnePointIsABoxWithoutSize) {
  const Box found = fitted({{7, 3, 1}});
  EXPECT_EQ(found.length_m, 0.0);
  EXPECT_EQ(found.height_m, 0.0);
  EXPECT_NEAR(found.centre_m[0], 7.0, 1e-14);
  EXPECT_NEAR(found.centre_m[1], 3.0, 1e-14);
}

// A roof seen from above puts points inside of the rectangle; closeness does not mind. Directions in which the long
// side stays within d0 = 1 cm of the rectangle's are equally good to it: 0.01 m / 4.5 m, and a step of the finer
// search.
TEST(BoxFit, PointsInsideDoNotTurnTheBox) {
  const Box car{.centre_m = {12, 6, 0}, .length_m = 4.5, .width_m = 1.8, .height_m = 1.4, .yaw_rad = 0.35};
  std::vector<Vector3> points = visibleSides(car, 0.05);
  for (double x = -1.0; x <= 1.0; x += 0.1) {
    for (double y = -0.6; y <= 0.6; y += 0.1) points.push_back(car.toWorld({x, y, 0.7}));
  }
  EXPECT_LE(turn(fitted(points), car), 0.01 / 4.5 + 0.05 * kRadPerDeg);
}

// Range noise of 2 cm: the sides touch the outermost points, so the box is too large by about two to six standard
// deviations (the expected largest of 90 to 180 normal numbers is 2.5 to 2.7 sigma), never too small by more than one.
TEST(BoxFit, NoiseMakesTheBoxLargerByAFewStandardDeviations) {
  const Box car{.centre_m = {15, 8, 0}, .length_m = 4.5, .width_m = 1.8, .height_m = 1.4, .yaw_rad = 0.1};
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    core::Random random({.seed = seed});
    std::vector<Vector3> points = visibleSides(car, 0.05);
    for (Vector3& p : points) {
      const double range = std::hypot(p[0], p[1]), factor = 1.0 + 0.02 * random.normal() / range;
      p = {p[0] * factor, p[1] * factor, p[2] * factor};
    }
    const Box found = fitted(points);
    EXPECT_LE(turn(found, car), 1.5 * kRadPerDeg) << seed;
    for (const double excess : {found.length_m - 4.5, found.width_m - 1.8}) {
      EXPECT_GT(excess, -0.02) << seed;
      EXPECT_LT(excess, 0.15) << seed;
    }
  }
}

}  // namespace
