#include "model/effects/declarations.h"
#include "model/material/reflection.h"

namespace model::effects {

namespace {

/// A water film makes rough surfaces darker and gives them a specular lobe (model/material/wet_film.h). `wetness` mixes
/// dry and wet.
class SurfaceMoisture final : public Effect {
 public:
  explicit SurfaceMoisture(const EffectParameters& parameters)
      : film_{parameters.numberOr("wetness", 0.5), parameters.numberOr("lobe_exponent", WetFilm::kLobeExponent),
              parameters.numberOr("film_reflectance", WetFilm::kReflectance)} {}

  [[nodiscard]] bool changesPower() const override { return true; }
  [[nodiscard]] double powerFactor(const Reflection& reflection) const override {
    return wetFactor(reflection.material, reflection.cos_incidence, film_);
  }

 private:
  WetFilm film_;
};

}  // namespace

EffectEntry surfaceMoisture() {
  return {.info = {.name = "surface-moisture",
                   .title = "Moisture on surfaces",
                   .summary = "Wet surfaces look darker, and more like mirrors.",
                   .stage = Stage::kInteraction,
                   .percollect = {"130"},
                   .parameters = {{"wetness", "", 0.0, 1.0, 0.5, "0 dry, 1 under a closed film", false, 0.6},
                                  {"lobe_exponent", "", 2.0, 2000.0, WetFilm::kLobeExponent,
                                   "How flat the film is: sharpness of its lobe", true, 100.0},
                                  {"film_reflectance", "", 0.012, 0.035, WetFilm::kReflectance,
                                   "Share of the light in the lobe of a closed film", true, 0.02}},
                   .fitted = {"wetness"},
                   .other_forms = {{"flatter or rougher film", {"wetness", "lobe_exponent"}},
                                   {"other film", {"wetness", "lobe_exponent", "film_reflectance"}, true}},
                   .source = "Lekner & Dorf 1988, doi:10.1364/AO.27.001278"},
          .make = makeFrom<SurfaceMoisture>};
}

}  // namespace model::effects
