#include "model/effects/declarations.h"
#include "model/material/reflection.h"

namespace model::effects {

namespace {

/// Non-Lambertian reflection, seen from where the light comes (monostatic: both angles are θ, same azimuth).
/// The factor is β(θ) / (Γ/π), so the material's hemispherical reflectivity Γ stays what it is. The models and their
/// sources are in model/material/: Oren–Nayar, diffuse + Phong lobe, Cook–Torrance, glass, measured table.
///
/// A material's own BRDF is used; a model given here applies to the materials that are Lambertian.
class AngularReflection final : public Effect {
 public:
  explicit AngularReflection(const EffectParameters& parameters) {
    if (parameters.textOr("model", "") == "oren-nayar" || parameters.number("roughness_rad")) {
      general_.brdf.model = BrdfModel::kOrenNayar;
      general_.brdf.roughness_rad = parameters.numberOr("roughness_rad", 0.35);
    } else if (parameters.textOr("model", "") == "phong" || parameters.number("diffuse_fraction")) {
      general_.brdf.model = BrdfModel::kPhong;
      general_.brdf.diffuse_fraction = parameters.numberOr("diffuse_fraction", 0.7);
      general_.brdf.exponent = parameters.numberOr("exponent", 20.0);
    }
  }

  void prepare(ChainSettings& settings, const Environment&) override {
    wavelength_nm_ = settings.emitter.wavelength_nm;
  }
  [[nodiscard]] bool changesPower() const override { return true; }
  [[nodiscard]] double powerFactor(const Reflection& reflection) const override {
    const BrdfModel own = reflection.material.brdf.model;
    if (own == BrdfModel::kRetroreflector) return 1.0;  // they have an effect of their own
    const Material& material = own == BrdfModel::kLambertian ? general_ : reflection.material;
    return monostaticFactor(material, reflection.cos_incidence, wavelength_nm_);
  }

 private:
  Material general_;
  double wavelength_nm_ = 905.0;
};

}  // namespace

EffectEntry angularReflection() {
  return {
      .info = {.name = "angular-reflection",
               .title = "Non-Lambertian reflection",
               .summary = "Surfaces do not throw light back evenly in all directions: how bright they are depends on "
                          "the angle at which the beam meets them.",
               .stage = Stage::kInteraction,
               .percollect = {"111", "114", "123"},
               .parameters = {{"roughness_rad", "rad", 0.0, 1.6, std::nullopt,
                               "Oren–Nayar: standard deviation of the facets' slope", false, 0.35},
                              {"diffuse_fraction", "", 0.0, 1.0, std::nullopt, "Phong: share of the diffuse part",
                               false, 0.8, 1.0},
                              {"exponent", "", 1.0, 1000.0, std::nullopt, "Phong: sharpness of the lobe", true, 20.0}},
               .fitted = {"diffuse_fraction", "exponent"},
               .other_forms = {{"oren-nayar", {"roughness_rad"}}},
               .source =
                   "Oren & Nayar 1994, doi:10.1145/192161.192213; Lafortune & Willems 1994, CW 197; Cook & Torrance "
                   "1982, doi:10.1145/357290.357293"},
      .make = makeFrom<AngularReflection>,
      .texts = {{"model", {"lambertian", "oren-nayar", "phong"}}}};
}

}  // namespace model::effects
