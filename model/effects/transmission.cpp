#include <algorithm>

#include "model/effects/declarations.h"
#include "model/material/fresnel.h"

namespace model::effects {

namespace {

/// Glass lets light pass: what stands behind it echoes too, weakened by the pane on the way out and back.
///
///   behind a pane    P · T(θ)²              T: of a pane with two faces and its absorption (material/fresnel.h)
///   the pane itself  P                      its reflectivity counts all light that falls on it (hemispherical)
///
/// T at normal incidence is the material's `transmission`, Fresnel's equations say how it falls with the angle. Every
/// surface of such a material is one whole pane: a box is made of two, and light goes straight on without being set
/// off to the side. At most two panes lie in a path. In the BRDF `glass` the reflectivity Γ is the share of dust: it
/// scatters whatever the pane lets pass, and light behind is weakened by ((1 - Γ) T)². Values given here replace those
/// of the materials that transmit at all; without the effect all of them are opaque.
/// Source: Born & Wolf, Principles of Optics, 7th ed., sec. 1.5.2; Stokes 1862, Proc. R. Soc. 11, 545.
class Transmission final : public Effect {
 public:
  explicit Transmission(const EffectParameters& parameters)
      : transmission_(parameters.number("transmission")), refractive_index_(parameters.number("refractive_index")) {}

  void prepare(ChainSettings& settings, const Environment&) override {
    constexpr int kPanes = 2;
    settings.most_crossings = std::max(settings.most_crossings, kPanes);
    wavelength_nm_ = settings.emitter.wavelength_nm;
  }
  [[nodiscard]] bool letsThrough(const Material& material) const override {
    return material.transmission > 0.0 && transmission_.value_or(1.0) > 0.0;
  }
  [[nodiscard]] bool changesPower() const override { return true; }
  [[nodiscard]] double powerFactor(const Reflection& reflection) const override {
    double factor = 1.0;
    for (const Crossing& crossing : reflection.crossings) {
      if (crossing.way != Crossing::Way::kThrough) continue;
      const double passes = clean(*crossing.material) * transmittance(*crossing.material, crossing.cos_incidence);
      factor *= passes * passes;
    }
    return factor;
  }

 private:
  /// Share of the surface that is not dust.
  static double clean(const Material& material) {
    return material.brdf.model == BrdfModel::kGlass ? 1.0 - material.reflectivity : 1.0;
  }
  [[nodiscard]] double transmittance(const Material& material, double cos_incidence) const {
    const ComplexIndex index =
        refractive_index_ ? ComplexIndex(*refractive_index_) : material.refractive_index.at(wavelength_nm_);
    const Pane pane = Pane::ofTransmission(index, transmission_.value_or(material.transmission));
    return pane.transmittance(cos_incidence).unpolarised();
  }

  std::optional<double> transmission_;
  std::optional<double> refractive_index_;
  double wavelength_nm_ = 905.0;
};

}  // namespace

EffectEntry transmission() {
  return {
      .info = {.name = "transmission",
               .title = "Transmission through glass",
               .summary =
                   "Glass lets a part of the light through: behind it a second echo may come, and both are weaker.",
               .stage = Stage::kInteraction,
               .percollect = {"110", "128"},
               .parameters = {{"transmission", "", 0.0, 1.0, std::nullopt,
                               "Share that passes at normal incidence; without it the material's", false, 0.8},
                              {"refractive_index", "", 1.0, 4.0, std::nullopt, "Without it the material's", false,
                               1.5}},
               .fitted = {"transmission"},
               .source = "Born & Wolf, Principles of Optics, 7th ed., sec. 1.5.2; Stokes 1862, Proc. R. Soc. 11, 545",
               .moves_geometry = true},
      .make = makeFrom<Transmission>};
}

}  // namespace model::effects
