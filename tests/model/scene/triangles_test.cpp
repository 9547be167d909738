#include "model/scene/triangles.h"

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>

#include "tests/model/lab.h"
#include "tests/support/paths.h"

namespace model {
namespace {

double area(const Triangles& triangles) {
  double sum = 0.0;
  for (const auto& face : triangles.faces) {
    const Vector3 &a = triangles.vertices[face[0]], &b = triangles.vertices[face[1]], &c = triangles.vertices[face[2]];
    const Vector3 u = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    sum += 0.5 * std::sqrt(std::pow(u[1] * v[2] - u[2] * v[1], 2) + std::pow(u[2] * v[0] - u[0] * v[2], 2) +
                           std::pow(u[0] * v[1] - u[1] * v[0], 2));
  }
  return sum;
}

/// Volume by the divergence theorem: right only if the surface is closed and all faces point outwards.
double volume(const Triangles& triangles) {
  double sum = 0.0;
  for (const auto& face : triangles.faces) {
    const Vector3 &a = triangles.vertices[face[0]], &b = triangles.vertices[face[1]], &c = triangles.vertices[face[2]];
    sum +=
        (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) /
        6.0;
  }
  return sum;
}

TEST(Triangles, SurfacesAndVolumesAreThoseOfTheShapes) {
  EXPECT_NEAR(area(trianglesOf(Rectangle{2, 3})), 6.0, 1e-12);
  EXPECT_NEAR(area(trianglesOf(Box{{1, 2, 3}})), 22.0, 1e-12);
  EXPECT_NEAR(std::abs(volume(trianglesOf(Box{{1, 2, 3}}))), 6.0, 1e-12);
  EXPECT_NEAR(area(trianglesOf(Cylinder{0.5, 2})), 2 * M_PI * 0.25 + 2 * M_PI * 0.5 * 2, 2e-3);
  EXPECT_NEAR(std::abs(volume(trianglesOf(Cylinder{0.5, 2}))), M_PI * 0.25 * 2, 1e-3);
}

/// A tetrahedron with legs 1, 2, 3 along the axes: volume 1.
const double kCorners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
const int kFaces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

std::string asObj() {
  std::string text;
  for (const auto& v : kCorners)
    text += "v " + std::to_string(v[0]) + " " + std::to_string(v[1]) + " " + std::to_string(v[2]) + "\n";
  for (const auto& f : kFaces)
    text += "f " + std::to_string(f[0] + 1) + " " + std::to_string(f[1] + 1) + " " + std::to_string(f[2] + 1) + "\n";
  return text;
}

std::string asPly() {
  std::string text =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 4\nproperty list uchar int vertex_indices\nend_header\n";
  for (const auto& v : kCorners)
    text += std::to_string(v[0]) + " " + std::to_string(v[1]) + " " + std::to_string(v[2]) + "\n";
  for (const auto& f : kFaces)
    text += "3 " + std::to_string(f[0]) + " " + std::to_string(f[1]) + " " + std::to_string(f[2]) + "\n";
  return text;
}

std::string asBinaryStl() {
  std::string text(80, ' ');
  const auto append = [&](const auto& value) {
    char bytes[sizeof(value)];
    std::memcpy(bytes, &value, sizeof(value));
    text.append(bytes, sizeof(value));
  };
  append(std::uint32_t{4});
  for (const auto& f : kFaces) {
    for (int i = 0; i < 3; ++i) append(0.0F);  // normal, recomputed by readers
    for (const int corner : f) {
      for (const double coordinate : kCorners[corner]) append(static_cast<float>(coordinate));
    }
    append(std::uint16_t{0});
  }
  return text;
}

TEST(Triangles, MeshesOfThreeFormatsAreTheSameBody) {
  const test_support::TemporaryFolder folder;
  for (const auto& file :
       {folder.write("t.obj", asObj()), folder.write("t.ply", asPly()), folder.write("t.stl", asBinaryStl())}) {
    const Triangles triangles = trianglesOf(Mesh{file, 1.0});
    EXPECT_EQ(triangles.faces.size(), 4u) << file;
    EXPECT_NEAR(std::abs(volume(triangles)), 1.0, 1e-6) << file;
    EXPECT_NEAR(area(triangles), 1.0 + 1.5 + 3.0 + 3.5, 1e-6) << file;
    EXPECT_NEAR(std::abs(volume(trianglesOf(Mesh{file, 2.0}))), 8.0, 1e-5) << file;  // scale
  }
}

// A mesh is as good as a built-in shape: the slanted face of the tetrahedron is x + y/2 + z/3 = 1.
TEST(Triangles, BeamMeetsAMeshAtItsFace) {
  const test_support::TemporaryFolder folder;
  (void)folder.write("meshes/t.obj", asObj());
  lab::Case setup;
  setup.file = folder / "experiment.json";
  // Turned by 180° about z at x = 10: the face looks at the sensor. World (10 - x, y0 - y, z0 + z).
  setup.scene = {lab::object("t", {{"type", "mesh"}, {"file", "meshes/t.obj"}}, {10, 0.4, -0.6}, {180, 0, 0})};
  const auto pulses = lab::pulses(setup);
  ASSERT_EQ(pulses.size(), 1u);
  const double depth = 1.0 - 0.4 / 2 - 0.6 / 3;  // local x of the hit
  EXPECT_NEAR(pulses[0].range_m, 10.0 - depth, 1e-5);
  const double cosine = 1.0 / std::sqrt(1.0 + 0.25 + 1.0 / 9.0);
  EXPECT_NEAR(pulses[0].power_w / lab::radarEquation(10.0 - depth, 0.5, cosine), 1.0, 1e-5);
}

}  // namespace
}  // namespace model
