#include "model/effects/declarations.h"

namespace model::effects {

namespace {

constexpr double kReferenceTemperature_degC = 20.0;

/// The oscillator that counts the time of flight is off, more so the warmer it is:
///   r_reported = r (1 + 1e-6 (scale + per_kelvin · (T - 20 °C)))
/// T is the experiment's temperature; where nobody recorded one, 20 °C.
class ClockDrift final : public Effect {
 public:
  explicit ClockDrift(const EffectParameters& parameters)
      : scale_ppm_(parameters.numberOr("scale_ppm", 0.0)),
        per_kelvin_ppm_(parameters.numberOr("per_kelvin_ppm", 0.0)) {}

  void prepare(ChainSettings& settings, const Environment& environment) override {
    const double warmer_K =
        environment.temperature_degC.value_or(kReferenceTemperature_degC) - kReferenceTemperature_degC;
    settings.range_scale *= 1.0 + 1e-6 * (scale_ppm_ + per_kelvin_ppm_ * warmer_K);
  }

 private:
  double scale_ppm_;
  double per_kelvin_ppm_;
};

}  // namespace

EffectEntry clockDrift() {
  return {
      .info = {.name = "clock-drift",
               .title = "Drift of the time base",
               .summary = "The clock that measures the time of flight runs too fast or too slow: the range error grows "
                          "with the range.",
               .stage = Stage::kPreProcessing,
               .parameters = {{"scale_ppm", "ppm", -2000.0, 2000.0, 0.0,
                               "Reported over true range, minus one, at 20 °C", false, 200.0},
                              {"per_kelvin_ppm", "ppm/K", -200.0, 200.0, 0.0, "Change of the scale with temperature",
                               false, 10.0}},
               .fitted = {"scale_ppm"},
               .other_forms = {{"with temperature", {"per_kelvin_ppm"}}},
               .source = "Glennie & Lichti 2010, doi:10.3390/rs2061610 (scale factor and its temperature dependence)"},
      .make = makeFrom<ClockDrift>};
}

}  // namespace model::effects
