#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "core/json_object.h"
#include "model/material/material.h"
#include "model/scene/pose.h"

namespace model {

struct Rectangle {
  double width_m, height_m;
};  ///< in its local y-z plane, front towards local -x
struct Box {
  Vector3 size_m;
};  ///< centred
struct Sphere {
  double radius_m;
};
struct Cylinder {
  double radius_m, height_m;
};                ///< axis z, centred, closed
struct Plane {};  ///< infinite, local z normal
struct Mesh {
  std::filesystem::path file;
  double scale;
};
using Shape = std::variant<Rectangle, Box, Sphere, Cylinder, Plane, Mesh>;

struct SceneObject {
  std::string id;
  Shape shape;
  Pose pose;  ///< at the start of the frame
  Vector3 velocity_m_s{};
  std::size_t material = 0;  ///< index into Scene::materials
};

/// All that a beam can hit. Sensor at the origin.
struct Scene {
  std::vector<Material> materials;  ///< in order of name
  std::vector<SceneObject> objects;
};

/// Reads `"materials"` and `"scene"` of an experiment object. Mesh files are relative to the experiment's file.
[[nodiscard]] Scene readScene(core::JsonObject& experiment);

/// Half extents of the object's own box around its local origin; planes and meshes (which know theirs only once they
/// are read) are unbounded.
[[nodiscard]] Vector3 halfExtents(const Shape& shape);

}  // namespace model
