#include <algorithm>
#include <cmath>

#include "model/effects/declarations.h"
#include "model/material/reflection.h"

namespace model::effects {

namespace {

/// Smooth surfaces mirror: the beam goes on to something else and returns on the same way, so a ghost stands in the
/// beam's own direction at the length of the whole path.
///
///   r = r_1 + r_2 (+ r_3 …),   P = P_t w η A_r (Γ/π) cos θ / r² · Π ρ_s²       one ρ_s per mirror, out and back
///
/// Mirrored share ρ_s of the light, by material (reflectivity Γ):
///
///   phong            Γ (1 - diffuse_fraction)
///   cook-torrance    (1 - diffuse_fraction) · Fresnel(θ)
///   glass            (1 - Γ) · Fresnel(θ), of both faces where it transmits
///   others           none
///
/// `specular_fraction` s replaces this for every material that is no glass: ρ_s = s Γ, and the diffuse return of these
/// is weakened by 1 - s. A target is one bounce, each mirror before it one more, of at most `max_bounces`.
/// Holds for lobes narrower than the target appears from the mirror; a wider one smears the ghost, here it stays sharp
/// and strong. Light that returns on another way than it went is left out.
/// Source: Born & Wolf, Principles of Optics, 7th ed., sec. 1.5.2 (reflectance); image source of a mirror.
class Multipath final : public Effect {
 public:
  explicit Multipath(const EffectParameters& parameters)
      : most_mirrors_(static_cast<int>(std::lround(parameters.numberOr("max_bounces", 2.0))) - 1),
        specular_fraction_(parameters.number("specular_fraction")) {}

  void prepare(ChainSettings& settings, const Environment&) override {
    settings.most_crossings = std::max(settings.most_crossings, most_mirrors_);
    wavelength_nm_ = settings.emitter.wavelength_nm;
  }
  [[nodiscard]] bool mirrors(const Material& material) const override {
    constexpr double kWorthTracing = 1e-3;
    // Traced whatever the fraction is, even zero: worlds that differ in it alone share their rays (power_only).
    if (specular_fraction_ && material.brdf.model != BrdfModel::kGlass) return material.reflectivity > 0.0;
    return mirroredShare(material, 1.0) > kWorthTracing;
  }
  [[nodiscard]] bool changesPower() const override { return true; }
  [[nodiscard]] double powerFactor(const Reflection& reflection) const override {
    double factor = 1.0;
    int mirrors = 0;
    for (const Crossing& crossing : reflection.crossings) {
      if (crossing.way != Crossing::Way::kMirrored) continue;
      const double share = mirroredShare(*crossing.material, crossing.cos_incidence);
      factor *= share * share;
      ++mirrors;
    }
    if (mirrors > most_mirrors_) return 0.0;  // traced for the sake of panes
    if (specular_fraction_ && reflection.material.brdf.model != BrdfModel::kGlass) factor *= 1.0 - *specular_fraction_;
    return factor;
  }

 private:
  [[nodiscard]] double mirroredShare(const Material& material, double cos_incidence) const {
    const Brdf& brdf = material.brdf;
    if (brdf.model == BrdfModel::kGlass) {
      return (1.0 - material.reflectivity) * specularReflectance(material, cos_incidence, wavelength_nm_);
    }
    if (specular_fraction_) return *specular_fraction_ * material.reflectivity;
    if (brdf.model == BrdfModel::kPhong) return (1.0 - brdf.diffuse_fraction) * material.reflectivity;
    if (brdf.model == BrdfModel::kCookTorrance) {
      return (1.0 - brdf.diffuse_fraction) * specularReflectance(material, cos_incidence, wavelength_nm_);
    }
    return 0.0;
  }

  int most_mirrors_;
  std::optional<double> specular_fraction_;
  double wavelength_nm_ = 905.0;
};

}  // namespace

EffectEntry multipath() {
  return {
      .info = {.name = "multipath",
               .title = "Second bounces by way of mirrors",
               .summary = "Light that a mirror-like surface turned aside comes back by a detour: objects seem to stand "
                          "where nothing is, too far away.",
               .stage = Stage::kInteraction,
               .percollect = {"108"},
               .parameters = {{"max_bounces", "", 2.0, 4.0, 2.0, "Bounces on the way out: the target and its mirrors",
                               false, 2.0},
                              {"specular_fraction", "", 0.0, 1.0, std::nullopt,
                               "Mirrored share of every surface's reflection; without it the material's", false, 0.3}},
               .other_forms = {{"every surface", {"specular_fraction"}}},
               .source = "Born & Wolf, Principles of Optics, 7th ed., sec. 1.5.2",
               .moves_geometry = true,
               .power_only = {"specular_fraction"}},
      .make = makeFrom<Multipath>};
}

}  // namespace model::effects
