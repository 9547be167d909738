#include "model/scene/triangles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/scene/mesh.h"

namespace model {

namespace {

Triangles quad(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d) {
  return {{a, b, c, d}, {{0, 1, 2}, {0, 2, 3}}};
}

Triangles boxTriangles(const Vector3& size) {
  Triangles triangles;
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      for (const double z : {-0.5, 0.5}) triangles.vertices.push_back({x * size[0], y * size[1], z * size[2]});
    }
  }
  triangles.faces = {{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
                     {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
  return triangles;
}

Triangles cylinderTriangles(const Cylinder& cylinder) {
  constexpr std::uint32_t kSides = 256;
  Triangles triangles;
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kSides;
    const double x = cylinder.radius_m * std::cos(angle), y = cylinder.radius_m * std::sin(angle);
    triangles.vertices.push_back({x, y, -cylinder.height_m / 2});
    triangles.vertices.push_back({x, y, cylinder.height_m / 2});
  }
  triangles.vertices.push_back({0, 0, -cylinder.height_m / 2});
  triangles.vertices.push_back({0, 0, cylinder.height_m / 2});
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % kSides);
    triangles.faces.push_back({a, b, b + 1});
    triangles.faces.push_back({a, b + 1, a + 1});
    triangles.faces.push_back({2 * kSides, b, a});
    triangles.faces.push_back({2 * kSides + 1, a + 1, b + 1});
  }
  return triangles;
}

}  // namespace

Triangles trianglesOf(const Shape& shape) {
  if (const auto* r = std::get_if<Rectangle>(&shape)) {
    const double y = r->width_m / 2, z = r->height_m / 2;
    return quad({0, -y, -z}, {0, y, -z}, {0, y, z}, {0, -y, z});
  }
  if (const auto* b = std::get_if<Box>(&shape)) return boxTriangles(b->size_m);
  if (const auto* c = std::get_if<Cylinder>(&shape)) return cylinderTriangles(*c);
  if (std::holds_alternative<Plane>(shape)) {
    constexpr double kFar_m = 5000.0;  // beyond every lidar's reach, near enough for single precision
    return quad({-kFar_m, -kFar_m, 0}, {kFar_m, -kFar_m, 0}, {kFar_m, kFar_m, 0}, {-kFar_m, kFar_m, 0});
  }
  if (const auto* m = std::get_if<Mesh>(&shape)) return readMesh(*m);
  return {};
}

Bounds localBounds(const Shape& shape) {
  if (!std::holds_alternative<Mesh>(shape)) {
    const Vector3 half = halfExtents(shape);
    return {{-half[0], -half[1], -half[2]}, half};
  }
  const Triangles triangles = trianglesOf(shape);
  Bounds bounds{triangles.vertices.front(), triangles.vertices.front()};
  for (const Vector3& vertex : triangles.vertices) {
    for (std::size_t k = 0; k < 3; ++k) {
      bounds.low[k] = std::min(bounds.low[k], vertex[k]);
      bounds.high[k] = std::max(bounds.high[k], vertex[k]);
    }
  }
  return bounds;
}

}  // namespace model
