#include "model/material/material.h"

#include <fmt/format.h>

#include "core/text.h"
#include "model/material/retroreflector.h"

namespace model {

namespace {

constexpr core::Bounds kPositive{.min = 0.0, .open_min = true};
constexpr core::Bounds kFraction{.min = 0.0, .max = 1.0};
constexpr core::Bounds kRoughness{.min = 0.001, .max = 1.0};
constexpr core::Bounds kIndex{.min = 1.0, .max = 10.0};

void readRetroreflector(core::JsonObject& object, double reflectivity, Brdf& brdf) {
  brdf.gain = object.number("gain", kPositive);
  brdf.half_width_rad = object.number("half_width_rad", kPositive);
  if (!object.has("observation_half_width_rad")) return;
  brdf.observation_half_width_rad =
      object.number("observation_half_width_rad", {.min = 0.0, .max = 0.1, .open_min = true});
  const double reflected =
      Retroreflector{brdf.gain, brdf.half_width_rad, brdf.observation_half_width_rad}.hemisphericalReflectance(
          reflectivity);
  if (reflected > 1.0) {
    object.fail(
        "observation_half_width_rad",
        "together with gain and reflectivity gives " + core::significant(reflected) + " times the light that falls in.",
        "A higher gain needs a narrower lobe.");
  }
}

void readTable(core::JsonObject& object, Material& material) {
  BrdfTableSource source;
  source.file = object.file().parent_path() / object.text("table");
  source.times_cos = object.choiceOr("values", {"brdf", "brdf-times-cos"}, "brdf") == "brdf-times-cos";
  source.clamp = object.choiceOr("outside", {"error", "clamp"}, "error") == "clamp";
  material.brdf.table = std::make_shared<const BrdfTable>(readBrdfTable(source, material.files));
}

/// Models whose return does not scale with the reflectivity are taken relative to it.
void needReflectivity(core::JsonObject& object, const Material& material) {
  if (material.reflectivity > 0.0) return;
  object.fail("model", "needs a reflectivity above 0 beside it: the chain takes every return relative to Lambert's.",
              "Give what is diffuse: 0.001 for clean glass or polished metal.");
}

void readBrdf(core::JsonObject object, Material& material) {
  Brdf& brdf = material.brdf;
  const std::string name = object.choice(
      "model", {"lambertian", "oren-nayar", "phong", "retroreflector", "cook-torrance", "glass", "table"});
  if (name == "oren-nayar") {
    brdf.model = BrdfModel::kOrenNayar;
    brdf.roughness_rad = object.number("roughness_rad", {.min = 0.0, .max = 1.6});
  } else if (name == "phong") {
    brdf.model = BrdfModel::kPhong;
    brdf.diffuse_fraction = object.number("diffuse_fraction", kFraction);
    brdf.exponent = object.number("exponent", {.min = 0.0});
  } else if (name == "retroreflector") {
    brdf.model = BrdfModel::kRetroreflector;
    readRetroreflector(object, material.reflectivity, brdf);
  } else if (name == "cook-torrance") {
    brdf.model = BrdfModel::kCookTorrance;
    needReflectivity(object, material);
    brdf.roughness = object.number("roughness", kRoughness);
    brdf.diffuse_fraction = object.numberOr("diffuse_fraction", 0.0, kFraction);
    brdf.microfacets = object.choiceOr("microfacets", {"ggx", "beckmann"}, "ggx") == "beckmann" ? Microfacets::kBeckmann
                                                                                                : Microfacets::kGgx;
  } else if (name == "glass") {
    brdf.model = BrdfModel::kGlass;
    needReflectivity(object, material);
    brdf.roughness = object.numberOr("roughness", 0.01, kRoughness);
  } else if (name == "table") {
    brdf.model = BrdfModel::kTable;
    readTable(object, material);
    if (brdf.table->quantity() != BrdfTable::Quantity::kFactor) needReflectivity(object, material);
  }
  object.finish();
}

/// A number, {"n", "k"} or {"file"}.
RefractiveIndex readRefractiveIndex(core::JsonObject& parent, Material& material) {
  if (!parent.has("refractive_index")) return {};
  if (!parent.raw("refractive_index").is_object()) return {{parent.number("refractive_index", kIndex), 0.0}};
  core::JsonObject object = parent.object("refractive_index");
  RefractiveIndex index;
  if (object.has("file")) {
    const auto file = object.file().parent_path() / object.text("file");
    index = RefractiveIndex(readOpticalConstants(file, material.files));
  } else {
    index = RefractiveIndex({object.number("n", kPositive), object.numberOr("k", 0.0, {.min = 0.0})});
  }
  object.finish();
  return index;
}

}  // namespace

Material readMaterial(const std::string& name, core::JsonObject object) {
  Material material;
  material.name = name;
  material.reflectivity = object.number("reflectivity", kFraction);
  if (object.has("brdf")) readBrdf(object.object("brdf"), material);
  material.transmission = object.numberOr("transmission", 0.0, kFraction);
  material.refractive_index = readRefractiveIndex(object, material);
  object.finish();
  return material;
}

}  // namespace model
