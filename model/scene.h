#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "core/json_object.h"

namespace model {

using Vector3 = std::array<double, 3>;

/// p = position + Rz(yaw) · Ry(pitch) · Rx(roll) · p_local; frame ISO 8855 (x forward, y left, z up).
struct Pose {
  Vector3 position_m{};
  double yaw_deg = 0.0;
  double pitch_deg = 0.0;
  double roll_deg = 0.0;

  /// Rows of the rotation Rz·Ry·Rx.
  [[nodiscard]] std::array<Vector3, 3> rotation() const;
  [[nodiscard]] Vector3 toWorld(const Vector3& local) const;
  [[nodiscard]] Vector3 toLocal(const Vector3& world) const;
};

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

enum class BrdfModel { kLambertian, kOrenNayar, kPhong, kRetroreflector };

/// Bidirectional reflectance; only the members that its model names count.
struct Brdf {
  BrdfModel model = BrdfModel::kLambertian;
  double roughness_rad = 0.0;
  double diffuse_fraction = 1.0;
  double exponent = 1.0;
  double gain = 1.0;
  double half_width_rad = 0.0;
};

struct Material {
  std::string name;
  double reflectivity = 0.0;  ///< hemispherical, at the emitter wavelength
  Brdf brdf;
  double transmission = 0.0;
  double refractive_index = 1.5;
};

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
