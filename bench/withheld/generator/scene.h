#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "bench/withheld/generator/fields.h"
#include "bench/withheld/generator/vec.h"

namespace withheld {

struct Material {
  enum class Law { lambertian, oren_nayar, phong, retroreflector };
  double reflectivity = 0.0;  ///< hemispherical, at the emitter's wavelength
  Law law = Law::lambertian;
  double roughness_rad = 0.0;
  double diffuse_fraction = 1.0, exponent = 1.0;
  double gain = 1.0, half_width_rad = 0.1;
  double transmission = 0.0, refractive_index = 1.5;
  double specular_fraction = 0.0;  ///< mirrored share of the reflection (1 - diffuse_fraction of phong)
};

struct Rectangle {
  double width_m, height_m;
};
struct Box {
  Vec half_m;
};
struct Sphere {
  double radius_m;
};
struct Cylinder {
  double radius_m, half_height_m;
};
struct Plane {};

struct Object {
  std::string id;
  std::variant<Rectangle, Box, Sphere, Cylinder, Plane> shape;
  Vec position;
  Turn turn;
  Vec velocity_m_s;
  Material material;
};

struct Ray {
  Vec from, along;  ///< unit vector
};

struct Hit {
  double range_m;
  int object;
  int face;    ///< which side of the shape; -1 on a curved one
  Vec normal;  ///< unit vector, against the ray
};

using Scene = std::vector<Object>;

/// Throws BadInput. Meshes and tabulated materials are refused.
[[nodiscard]] Scene readScene(const Json& experiment, const std::string& place);

/// The nearest surface beyond 1 nm, `shift` added to every object's position times its velocity. [s]
/// Closed forms: planes, slabs (Kay & Kajiya 1986, doi:10.1145/15922.15916), quadratics.
[[nodiscard]] std::optional<Hit> nearestHit(const Scene& scene, const Ray& ray, double moved_s);

}  // namespace withheld
