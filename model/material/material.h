#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/json_object.h"
#include "model/material/brdf_table.h"
#include "model/material/cook_torrance.h"
#include "model/material/refractive_index.h"

namespace model {

enum class BrdfModel { kLambertian, kOrenNayar, kPhong, kRetroreflector, kCookTorrance, kGlass, kTable };

/// Bidirectional reflectance; only the members that its model names count.
struct Brdf {
  BrdfModel model = BrdfModel::kLambertian;
  double roughness_rad = 0.0;  ///< Oren–Nayar
  double diffuse_fraction = 1.0;
  double exponent = 1.0;
  double gain = 1.0;
  double half_width_rad = 0.0;
  double observation_half_width_rad = 0.007;    ///< of a retroreflector
  double roughness = 0.1;                       ///< of microfacets: Cook–Torrance, glass
  Microfacets microfacets = Microfacets::kGgx;  ///< Cook–Torrance
  std::shared_ptr<const BrdfTable> table = {};
};

/// What a surface does with light. reflection.h says what that means for a lidar.
struct Material {
  std::string name;
  double reflectivity = 0.0;  ///< hemispherical, at the emitter wavelength
  Brdf brdf;
  double transmission = 0.0;  ///< share that passes at normal incidence
  RefractiveIndex refractive_index;
  std::vector<std::filesystem::path> files = {};  ///< tables that it was read from
};

/// Reads one entry of an experiment's `"materials"`. Files are relative to the experiment's.
[[nodiscard]] Material readMaterial(const std::string& name, core::JsonObject object);

}  // namespace model
