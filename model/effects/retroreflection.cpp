#include <algorithm>
#include <cmath>

#include "model/effects/declarations.h"

namespace model::effects {

namespace {

/// Corner cubes and glass beads send the light back where it came from. On materials whose BRDF is `retroreflector`:
///
///   P = P_lambertian · (1 + (gain - 1) · 2^-(θ/θ_h)²)
///
///   gain  return at normal incidence over that of a Lambertian of the same reflectivity
///   θ_h   entrance angle at which the surplus has fallen to one half (`half_width_rad`)
///
/// Sender and receiver are one, so the observation angle is zero. Parameters given here replace the materials' own.
/// Source: ASTM E808-01 (geometry); Lloyd 2008, Retroreflection, ch. 2 (entrance angularity).
class Retroreflection final : public Effect {
 public:
  explicit Retroreflection(const EffectParameters& parameters)
      : gain_(parameters.number("gain")), half_width_rad_(parameters.number("half_width_rad")) {}

  [[nodiscard]] bool changesPower() const override { return true; }
  [[nodiscard]] double powerFactor(const Reflection& reflection) const override {
    const Brdf& brdf = reflection.material.brdf;
    if (brdf.model != BrdfModel::kRetroreflector) return 1.0;
    const double angle =
        std::acos(std::clamp(reflection.cos_incidence, 0.0, 1.0)) / half_width_rad_.value_or(brdf.half_width_rad);
    return 1.0 + (gain_.value_or(brdf.gain) - 1.0) * std::exp2(-angle * angle);
  }

 private:
  std::optional<double> gain_;
  std::optional<double> half_width_rad_;
};

}  // namespace

EffectEntry retroreflection() {
  return {.info = {.name = "retroreflection",
                   .title = "Retroreflection",
                   .stage = Stage::kInteraction,
                   .percollect = {"111", "139"},
                   .parameters = {{"gain", "", 10.0, 1e5, std::nullopt,
                                   "Return over that of a Lambertian; without it the material's", true, 300.0},
                                  {"half_width_rad", "rad", 0.01, 1.5, std::nullopt,
                                   "Entrance angle of half the surplus; without it the material's", true, 0.5}},
                   .fitted = {"gain"},
                   .source = "ASTM E808-01; Lloyd 2008, Retroreflection"},
          .make = makeFrom<Retroreflection>};
}

}  // namespace model::effects
