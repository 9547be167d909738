#pragma once

#include <string>

#include "core/json_object.h"

namespace model {

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

/// Reads one entry of an experiment's `"materials"`.
[[nodiscard]] Material readMaterial(const std::string& name, core::JsonObject object);

}  // namespace model
