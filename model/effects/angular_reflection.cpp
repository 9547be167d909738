#include <algorithm>
#include <cmath>

#include "model/effects/declarations.h"

namespace model::effects {

namespace {

/// Non-Lambertian reflection, seen from where the light comes (monostatic: both angles are θ, same azimuth).
/// The factor is β(θ) / (Γ/π), so the material's hemispherical reflectivity Γ stays what it is.
///
///   Oren–Nayar: A + B sin θ tan θ,  A = 1 - 0.5 σ²/(σ²+0.33),  B = 0.45 σ²/(σ²+0.09)
///               Source: Oren & Nayar 1994, doi:10.1145/192161.192213, eq. 30
///   Phong:      k_d + (1-k_d) (n+2)/2 · cos^n(2θ): the mirror direction is 2θ away from the sensor
///               Source: Lafortune & Willems 1994, CW 197, eq. 9
///
/// A material's own BRDF is used; a model given here applies to the materials that are Lambertian.
class AngularReflection final : public Effect {
 public:
  explicit AngularReflection(const EffectParameters& parameters) {
    if (parameters.textOr("model", "") == "oren-nayar" || parameters.number("roughness_rad")) {
      general_.model = BrdfModel::kOrenNayar;
      general_.roughness_rad = parameters.numberOr("roughness_rad", 0.35);
    } else if (parameters.textOr("model", "") == "phong" || parameters.number("diffuse_fraction")) {
      general_.model = BrdfModel::kPhong;
      general_.diffuse_fraction = parameters.numberOr("diffuse_fraction", 0.7);
      general_.exponent = parameters.numberOr("exponent", 20.0);
    }
  }

  [[nodiscard]] bool changesPower() const override { return true; }
  [[nodiscard]] double powerFactor(const Reflection& reflection) const override {
    const Brdf& own = reflection.material.brdf;
    const Brdf& brdf = own.model == BrdfModel::kLambertian ? general_ : own;
    if (brdf.model == BrdfModel::kOrenNayar) return orenNayar(brdf.roughness_rad, reflection.cos_incidence);
    if (brdf.model == BrdfModel::kPhong) return phong(brdf, reflection.cos_incidence);
    return 1.0;  // retroreflectors have an effect of their own
  }

 private:
  static double orenNayar(double roughness_rad, double cos_incidence) {
    const double s = roughness_rad * roughness_rad;
    const double a = 1.0 - 0.5 * s / (s + 0.33), b = 0.45 * s / (s + 0.09);
    const double c = std::max(cos_incidence, 1e-6);
    return a + b * (1.0 - c * c) / c;
  }
  static double phong(const Brdf& brdf, double cos_incidence) {
    const double cos_mirror = std::max(0.0, 2.0 * cos_incidence * cos_incidence - 1.0);  // cos 2θ
    return brdf.diffuse_fraction +
           (1.0 - brdf.diffuse_fraction) * (brdf.exponent + 2.0) / 2.0 * std::pow(cos_mirror, brdf.exponent);
  }

  Brdf general_;
};

}  // namespace

EffectEntry angularReflection() {
  return {
      .info = {.name = "angular-reflection",
               .title = "Non-Lambertian reflection",
               .stage = Stage::kInteraction,
               .percollect = {"111", "114", "123"},
               .parameters = {{"roughness_rad", "rad", 0.0, 1.6, std::nullopt,
                               "Oren–Nayar: standard deviation of the facets' slope", false, 0.35},
                              {"diffuse_fraction", "", 0.0, 1.0, std::nullopt, "Phong: share of the diffuse part",
                               false, 0.8},
                              {"exponent", "", 1.0, 1000.0, std::nullopt, "Phong: sharpness of the lobe", true, 20.0}},
               .fitted = {"diffuse_fraction", "exponent"},
               .source = "Oren & Nayar 1994, doi:10.1145/192161.192213; Lafortune & Willems 1994, CW 197"},
      .make = makeFrom<AngularReflection>,
      .texts = {{"model", {"lambertian", "oren-nayar", "phong"}}}};
}

}  // namespace model::effects
