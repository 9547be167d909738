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

/// The surface of a shape; spheres are not triangulated (empty). Meshes are read through assimp.
[[nodiscard]] Triangles trianglesOf(const Shape& shape);

}  // namespace model
