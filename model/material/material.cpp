#include "model/material/material.h"

namespace model {

namespace {

constexpr core::Bounds kPositive{.min = 0.0, .open_min = true};
constexpr core::Bounds kFraction{.min = 0.0, .max = 1.0};

Brdf readBrdf(core::JsonObject object) {
  Brdf brdf;
  const std::string name = object.choice("model", {"lambertian", "oren-nayar", "phong", "retroreflector"});
  if (name == "oren-nayar") {
    brdf.model = BrdfModel::kOrenNayar;
    brdf.roughness_rad = object.number("roughness_rad", {.min = 0.0, .max = 1.6});
  } else if (name == "phong") {
    brdf.model = BrdfModel::kPhong;
    brdf.diffuse_fraction = object.number("diffuse_fraction", kFraction);
    brdf.exponent = object.number("exponent", {.min = 0.0});
  } else if (name == "retroreflector") {
    brdf.model = BrdfModel::kRetroreflector;
    brdf.gain = object.number("gain", kPositive);
    brdf.half_width_rad = object.number("half_width_rad", kPositive);
  }
  object.finish();
  return brdf;
}

}  // namespace

Material readMaterial(const std::string& name, core::JsonObject object) {
  Material material;
  material.name = name;
  material.reflectivity = object.number("reflectivity", kFraction);
  if (object.has("brdf")) material.brdf = readBrdf(object.object("brdf"));
  material.transmission = object.numberOr("transmission", 0.0, kFraction);
  material.refractive_index = object.numberOr("refractive_index", 1.5, {.min = 1.0, .max = 10.0});
  object.finish();
  return material;
}

}  // namespace model
