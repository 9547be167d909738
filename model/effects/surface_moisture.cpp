#include <algorithm>
#include <cmath>

#include "model/effects/declarations.h"

namespace model::effects {

namespace {

constexpr double kFilmReflectance = 0.02;  ///< Fresnel, air to water (n = 1.33), normal incidence
constexpr double kReflectedInside =
    0.472;                               ///< share of diffuse light that a water film throws back: 1 - (1 - 0.066)/n²
constexpr double kLobeExponent = 100.0;  ///< of the film's specular lobe

/// A water film makes a rough surface darker and gives it a specular lobe. Wet, with A the dry reflectivity:
///
///   diffuse   A_wet = (1 - F)(1 - p) A / (1 - p A)      light is trapped under the film and absorbed
///   specular  F (n+2)/2 cos^n(2θ)                       the mirror direction is 2θ away from the sensor
///
/// `wetness` mixes dry and wet.
/// Source: Lekner & Dorf 1988, doi:10.1364/AO.27.001278 (after Ångström 1925).
class SurfaceMoisture final : public Effect {
 public:
  explicit SurfaceMoisture(const EffectParameters& parameters) : wetness_(parameters.numberOr("wetness", 0.5)) {}

  [[nodiscard]] bool changesPower() const override { return true; }
  [[nodiscard]] double powerFactor(const Reflection& reflection) const override {
    const double dry = reflection.material.reflectivity;
    if (dry <= 0.0) return 1.0;
    const double diffuse = (1.0 - kFilmReflectance) * (1.0 - kReflectedInside) / (1.0 - kReflectedInside * dry);
    const double cos_mirror = std::max(0.0, 2.0 * reflection.cos_incidence * reflection.cos_incidence - 1.0);
    const double specular = kFilmReflectance / dry * (kLobeExponent + 2.0) / 2.0 * std::pow(cos_mirror, kLobeExponent);
    return 1.0 - wetness_ + wetness_ * (diffuse + specular);
  }

 private:
  double wetness_;
};

}  // namespace

EffectEntry surfaceMoisture() {
  return {.info = {.name = "surface-moisture",
                   .title = "Moisture on surfaces",
                   .stage = Stage::kInteraction,
                   .percollect = {"130"},
                   .parameters = {{"wetness", "", 0.0, 1.0, 0.5, "0 dry, 1 under a closed film", false, 0.6}},
                   .fitted = {"wetness"},
                   .source = "Lekner & Dorf 1988, doi:10.1364/AO.27.001278"},
          .make = makeFrom<SurfaceMoisture>};
}

}  // namespace model::effects
