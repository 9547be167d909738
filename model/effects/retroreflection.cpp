#include "model/effects/declarations.h"
#include "model/material/retroreflector.h"

namespace model::effects {

namespace {

/// Corner cubes and glass beads send the light back where it came from, on materials whose BRDF is `retroreflector`
/// (model/material/retroreflector.h). Sender and receiver are one, so the observation angle is zero. Parameters given
/// here replace the materials' own.
class Retroreflection final : public Effect {
 public:
  explicit Retroreflection(const EffectParameters& parameters)
      : gain_(parameters.number("gain")), half_width_rad_(parameters.number("half_width_rad")) {}

  [[nodiscard]] bool changesPower() const override { return true; }
  [[nodiscard]] double powerFactor(const Reflection& reflection) const override {
    const Brdf& brdf = reflection.material.brdf;
    if (brdf.model != BrdfModel::kRetroreflector) return 1.0;
    return Retroreflector{.gain = gain_.value_or(brdf.gain),
                          .half_width_rad = half_width_rad_.value_or(brdf.half_width_rad)}
        .monostaticFactor(reflection.cos_incidence);
  }

 private:
  std::optional<double> gain_;
  std::optional<double> half_width_rad_;
};

}  // namespace

EffectEntry retroreflection() {
  return {.info = {.name = "retroreflection",
                   .title = "Retroreflection",
                   .summary = "Reflectors (signs, licence plates, reflective tape) throw far more light back to the "
                              "sensor than other surfaces.",
                   .stage = Stage::kInteraction,
                   .percollect = {"111", "139"},
                   .parameters = {{"gain", "", 10.0, 1e5, std::nullopt,
                                   "Return over that of a Lambertian; without it the material's", true, 300.0},
                                  {"half_width_rad", "rad", 0.01, 1.5, std::nullopt,
                                   "Entrance angle of half the surplus; without it the material's", true, 0.5}},
                   .fitted = {"gain"},
                   .other_forms = {{"other width", {"gain", "half_width_rad"}}},
                   .source = "ASTM E808-01; Lloyd 2008, Retroreflection"},
          .make = makeFrom<Retroreflection>};
}

}  // namespace model::effects
