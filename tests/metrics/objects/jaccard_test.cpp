#include "metrics/objects/jaccard.h"

#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <numbers>

#include "core/error.h"
#include "tests/metrics/objects/random_objects.h"
#include "tests/support/paths.h"

namespace {

using metrics::jaccardDistance;
using metrics::Object;
using metrics::OrientedBox;
using metrics::sharedArea;
using metrics_test::ObjectList;
using metrics_test::RandomClouds;
using std::numbers::pi;

OrientedBox square(double x, double y, double side, double yaw = 0.0) {
  return {.x_m = x, .y_m = y, .footprint = {.length_m = side, .width_m = side, .yaw_rad = yaw}};
}

OrientedBox randomBox(RandomClouds& cases) {
  return {
      .x_m = cases.uniform(-1.0, 1.0),
      .y_m = cases.uniform(-1.0, 1.0),
      .footprint = {
          .length_m = cases.uniform(0.5, 4.0), .width_m = cases.uniform(0.5, 2.0), .yaw_rad = cases.uniform(-pi, pi)}};
}

// Turned by 45 degrees on its centre, a unit square leaves a regular octagon with inradius 1/2: area 2 (sqrt 2 - 1),
// hence IoU 1 / sqrt 2.
TEST(SharedArea, OfASquareTurnedByHalfARightAngleIsAnOctagon) {
  const double octagon = 2.0 * (std::sqrt(2.0) - 1.0);
  EXPECT_NEAR(sharedArea(square(3.0, 4.0, 1.0), square(3.0, 4.0, 1.0, pi / 4.0)), octagon, 1e-14);
  EXPECT_NEAR(jaccardDistance(square(3.0, 4.0, 1.0), square(3.0, 4.0, 1.0, pi / 4.0)), 1.0 - 1.0 / std::sqrt(2.0),
              1e-14);
}

TEST(SharedArea, OfUnturnedBoxesIsTheProductOfOverlaps) {
  EXPECT_DOUBLE_EQ(sharedArea(square(0.0, 0.0, 2.0), square(1.0, 0.5, 2.0)), 1.5);
  EXPECT_EQ(sharedArea(square(0.0, 0.0, 2.0), square(0.25, 0.25, 1.0)), 1.0);  // inside
  EXPECT_EQ(sharedArea(square(0.0, 0.0, 2.0), square(2.0, 0.0, 2.0)), 0.0);    // touching
  EXPECT_EQ(sharedArea(square(0.0, 0.0, 2.0), square(9.0, 9.0, 2.0)), 0.0);
}

// A corner cut off: the square |x| + |y| <= sqrt(2) / 2 of side 1, moved so that its centre is the corner of a large
// box.
TEST(SharedArea, OfADiamondOnACornerIsAQuarter) {
  EXPECT_NEAR(sharedArea(square(5.0, 5.0, 10.0), square(10.0, 10.0, 1.0, pi / 4.0)), 0.25, 1e-14);
}

// shapely 1.8.5, GEOS: 200 pairs. Tolerance: coordinates to 8 m, areas to 36 m^2.
TEST(SharedArea, AgreesWithShapely) {
  std::ifstream file(test_support::testData("metrics/objects/box_oracles.csv"));
  int lines = 0;
  const auto readBox = [&file](OrientedBox& box) {
    char comma = ',';
    auto& [length, width, yaw] = box.footprint;
    return static_cast<bool>(file >> box.x_m >> comma >> box.y_m >> comma >> length >> comma >> width >> comma >> yaw >>
                             comma);
  };
  OrientedBox a;
  OrientedBox b;
  double shared = 0.0;
  while (readBox(a) && readBox(b) && file >> shared) {
    ++lines;
    EXPECT_NEAR(sharedArea(a, b), shared, 1e-12);
    EXPECT_NEAR(sharedArea(b, a), shared, 1e-12);
  }
  EXPECT_EQ(lines, 200);
}

TEST(JaccardDistance, IsAMetricOnBoxes) {
  RandomClouds cases(40);
  for (int k = 0; k < 1000; ++k) {
    const OrientedBox a = randomBox(cases);
    const OrientedBox b = randomBox(cases);
    const OrientedBox c = randomBox(cases);
    EXPECT_EQ(jaccardDistance(a, a), 0.0);
    EXPECT_NEAR(jaccardDistance(a, b), jaccardDistance(b, a), 1e-14);
    EXPECT_LE(jaccardDistance(a, c), jaccardDistance(a, b) + jaccardDistance(b, c) + 1e-14);
  }
}

TEST(JaccardDistance, IsTheSameForABoxTurnedByAHalfTurn) {
  RandomClouds cases(41);
  for (int k = 0; k < 100; ++k) {
    const OrientedBox a = randomBox(cases);
    OrientedBox b = randomBox(cases);
    const double before = jaccardDistance(a, b);
    b.footprint.yaw_rad += pi;
    EXPECT_NEAR(jaccardDistance(a, b), before, 1e-13);
    std::swap(b.footprint.length_m, b.footprint.width_m);
    b.footprint.yaw_rad += pi / 2.0;
    EXPECT_NEAR(jaccardDistance(a, b), before, 1e-13);
  }
}

TEST(JaccardDistance, OfBoxesWithoutAreaIsZeroAndOfOneIsOne) {
  EXPECT_EQ(jaccardDistance(square(0.0, 0.0, 0.0), square(1.0, 0.0, 0.0)), 0.0);
  EXPECT_EQ(jaccardDistance(square(0.0, 0.0, 1.0), square(0.0, 0.0, 0.0)), 1.0);
}

// Measured: two unit squares. Simulated: the first one half covered (IoU 1/3), two more elsewhere.
TEST(JaccardDistance, OfListsIsTheMeanOverTheLargerOne) {
  const auto at = [](double x) { return Object{.position = {.x_m = x}, .footprint = {{.length_m = 1, .width_m = 1}}}; };
  const ObjectList measured{at(0.0), at(10.0)};
  const ObjectList simulated{at(20.0), at(0.5), at(30.0)};
  EXPECT_NEAR(jaccardDistance({.simulated = simulated, .measured = measured}), (2.0 / 3.0 + 1.0 + 1.0) / 3.0, 1e-15);
  EXPECT_EQ(jaccardDistance({.simulated = simulated, .measured = simulated}), 0.0);
  EXPECT_EQ(jaccardDistance({.simulated = simulated, .measured = {}}), 1.0);
  EXPECT_EQ(jaccardDistance(metrics::ObjectLists{}), 0.0);
}

TEST(JaccardDistance, NamesTheObjectWithoutSize) {
  const ObjectList points(2);
  try {
    (void)jaccardDistance({.simulated = points, .measured = {}});
    FAIL() << "took a point for a box";
  } catch (const core::InputError& error) {
    EXPECT_EQ(error.place().item, "simulated object 1");
  }
}

}  // namespace
