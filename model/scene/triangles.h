#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "model/scene/scene.h"

namespace model {

/// Triangles in the shape's local frame.
struct Triangles {
  std::vector<Vector3> vertices;
  std::vector<std::array<std::uint32_t, 3>> faces;
};

/// The surface of a shape; spheres are not triangulated (empty). A mesh is read from its file every time: ask a
/// MeshLibrary (mesh.h) where the same one may stand in a scene many times.
[[nodiscard]] Triangles trianglesOf(const Shape& shape);

/// Lowest and highest corner of a shape in its local frame; infinite where a plane has no end. Meshes are read.
struct Bounds {
  Vector3 low{};
  Vector3 high{};
};
[[nodiscard]] Bounds localBounds(const Shape& shape);

}  // namespace model
