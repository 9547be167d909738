#include "bench/mesh_builder.h"

#include <cmath>
#include <numbers>

namespace bench {

std::uint32_t MeshBuilder::vertex(const Vector3& at) {
  triangles_.vertices.push_back(at);
  return static_cast<std::uint32_t>(triangles_.vertices.size() - 1);
}

void MeshBuilder::triangle(const Vector3& a, const Vector3& b, const Vector3& c) {
  const std::uint32_t first = vertex(a);
  vertex(b);
  vertex(c);
  triangles_.faces.push_back({first, first + 1, first + 2});
}

void MeshBuilder::quad(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d) {
  const std::uint32_t first = vertex(a);
  vertex(b);
  vertex(c);
  vertex(d);
  triangles_.faces.push_back({first, first + 1, first + 2});
  triangles_.faces.push_back({first, first + 2, first + 3});
}

void MeshBuilder::box(const Vector3& centre, const Vector3& size) {
  const model::Triangles box = model::trianglesOf(model::Box{size});
  const auto first = static_cast<std::uint32_t>(triangles_.vertices.size());
  for (const Vector3& corner : box.vertices)
    vertex({centre[0] + corner[0], centre[1] + corner[1], centre[2] + corner[2]});
  for (const auto& face : box.faces) triangles_.faces.push_back({first + face[0], first + face[1], first + face[2]});
}

void MeshBuilder::tube(const Vector3& from, const Vector3& to, double from_radius, double to_radius, int sides) {
  const Vector3 axis = {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
  // Two directions across the axis; the first is level unless the axis itself is upright.
  const double level = std::hypot(axis[0], axis[1]), length = std::hypot(level, axis[2]);
  const bool upright = level < 1e-9 * length;
  const Vector3 u = upright ? Vector3{1, 0, 0} : Vector3{-axis[1] / level, axis[0] / level, 0};
  const Vector3 v = {(axis[1] * u[2] - axis[2] * u[1]) / length, (axis[2] * u[0] - axis[0] * u[2]) / length,
                     (axis[0] * u[1] - axis[1] * u[0]) / length};
  const auto around = [&](const Vector3& centre, double radius, double angle) {
    const double c = radius * std::cos(angle), s = radius * std::sin(angle);
    return vertex({centre[0] + c * u[0] + s * v[0], centre[1] + c * u[1] + s * v[1], centre[2] + c * u[2] + s * v[2]});
  };
  const auto first = static_cast<std::uint32_t>(triangles_.vertices.size());
  for (int i = 0; i < sides; ++i) {
    around(from, from_radius, 2.0 * std::numbers::pi * i / sides);
    around(to, to_radius, 2.0 * std::numbers::pi * i / sides);
  }
  const std::uint32_t low = vertex(from), high = vertex(to), count = static_cast<std::uint32_t>(sides);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t a = first + 2 * i, b = first + 2 * ((i + 1) % count);
    triangles_.faces.insert(triangles_.faces.end(),
                            {{a, b, b + 1}, {a, b + 1, a + 1}, {low, b, a}, {high, a + 1, b + 1}});
  }
}

void MeshBuilder::grid(int along, int across, const std::function<Vector3(double, double)>& point) {
  const auto first = static_cast<std::uint32_t>(triangles_.vertices.size());
  for (int i = 0; i <= along; ++i) {
    for (int j = 0; j <= across; ++j) vertex(point(static_cast<double>(i) / along, static_cast<double>(j) / across));
  }
  const auto row = static_cast<std::uint32_t>(across + 1);
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(along); ++i) {
    for (std::uint32_t j = 0; j + 1 < row; ++j) {
      const std::uint32_t a = first + i * row + j;
      triangles_.faces.push_back({a, a + row, a + row + 1});
      triangles_.faces.push_back({a, a + row + 1, a + 1});
    }
  }
}

void MeshBuilder::loft(int rings, int corners, const std::function<Vector3(double, double)>& ring) {
  const auto first = static_cast<std::uint32_t>(triangles_.vertices.size());
  const auto n = static_cast<std::uint32_t>(corners), last = static_cast<std::uint32_t>(rings - 1);
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < corners; ++j)
      vertex(ring(static_cast<double>(i) / (rings - 1), 2.0 * std::numbers::pi * j / corners));
  }
  for (std::uint32_t i = 0; i < last; ++i) {
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t a = first + i * n + j, b = first + i * n + (j + 1) % n;
      triangles_.faces.push_back({a, a + n, b + n});
      triangles_.faces.push_back({a, b + n, b});
    }
  }
  for (const std::uint32_t end : {std::uint32_t{0}, last}) {
    Vector3 middle{};
    for (std::uint32_t j = 0; j < n; ++j) {
      for (std::size_t k = 0; k < 3; ++k) middle[k] += triangles_.vertices[first + end * n + j][k] / corners;
    }
    const std::uint32_t centre = vertex(middle);
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t a = first + end * n + j, b = first + end * n + (j + 1) % n;
      if (end == 0) {
        triangles_.faces.push_back({centre, a, b});
      } else {
        triangles_.faces.push_back({centre, b, a});
      }
    }
  }
}

}  // namespace bench
