#include "bench/street.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>

#include "tests/support/paths.h"

namespace {

using model::Triangles;
using model::Vector3;

const Triangles& theStreet() {
  static const Triangles street = bench::street();
  return street;
}

double area(const Triangles& triangles, const std::array<std::uint32_t, 3>& face) {
  const Vector3 &a = triangles.vertices[face[0]], &b = triangles.vertices[face[1]], &c = triangles.vertices[face[2]];
  const Vector3 u = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  return std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2;
}

TEST(Street, HasAsManyTrianglesAsAskedAndNoneIsDegenerate) {
  EXPECT_EQ(theStreet().faces.size(), 207'000U);
  for (const auto& face : theStreet().faces) ASSERT_GT(area(theStreet(), face), 1e-6);
}

TEST(Street, IsTheSameEveryTimeAndAnotherForAnotherSeed) {
  EXPECT_EQ(bench::street().vertices, theStreet().vertices);
  EXPECT_NE(bench::street({.seed = 2}).vertices, theStreet().vertices);
}

// Straight below the sensor lies the road, 1.75 m right of its crown: 2 % of 1.75 m lower, ±4 mm of roughness.
TEST(Street, RoadLiesBelowTheSensorAndNothingElseIsNear) {
  double nearest = 1e9;
  for (const Vector3& v : theStreet().vertices) {
    if (std::hypot(v[0], v[1]) < 1.5) {
      EXPECT_NEAR(v[2], -1.8 - 0.02 * std::abs(v[1] - 1.75), 0.005);
      nearest = std::min(nearest, std::hypot(v[0], v[1]));
    }
  }
  EXPECT_LT(nearest, 1.0);
}

TEST(Street, TooFewTrianglesAreRefused) {
  EXPECT_THROW((void)bench::street({.triangles = 1000}), std::invalid_argument);
}

TEST(Street, ComesBackFromItsMeshFiles) {
  const test_support::TemporaryFolder folder;
  for (const char* name : {"street.ply", "street.obj"}) {
    bench::writeMesh(theStreet(), folder / name);
    const Triangles read = model::trianglesOf(model::Mesh{.file = folder / name, .scale = 1.0});
    EXPECT_EQ(read.faces.size(), theStreet().faces.size()) << name;
    double written_area = 0.0, read_area = 0.0;
    for (const auto& face : theStreet().faces) written_area += area(theStreet(), face);
    for (const auto& face : read.faces) read_area += area(read, face);
    EXPECT_NEAR(read_area, written_area, 1e-4 * written_area) << name;
  }
}

}  // namespace
