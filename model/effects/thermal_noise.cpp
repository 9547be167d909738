#include <cmath>

#include "model/effects/declarations.h"

namespace model::effects {

namespace {

constexpr double kReferenceTemperature_degC = 20.0;
constexpr double kDoubling_K = 8.0;

/// The dark current of the detector doubles with every 8 K, and its shot noise has a variance proportional to it:
///
///   σ²(T) = σ_20² · (1 - s + s · 2^((T - 20 °C)/8 K))
///
/// s is the share of the variance at 20 °C that comes from dark current. T is the parameter, else the experiment's
/// temperature, else 20 °C.
/// Source: Sze & Ng 2007, Physics of Semiconductor Devices, ch. 13 (generation current of silicon photodiodes).
class ThermalNoise final : public Effect {
 public:
  explicit ThermalNoise(const EffectParameters& parameters)
      : given_degC_(parameters.number("temperature_degC")), share_(parameters.numberOr("dark_share", 1.0)) {}

  void prepare(ChainSettings& settings, const Environment& environment) override {
    const double temperature_degC =
        given_degC_.value_or(environment.temperature_degC.value_or(kReferenceTemperature_degC));
    settings.receiver.noise_w *=
        std::sqrt(1.0 - share_ + share_ * std::exp2((temperature_degC - kReferenceTemperature_degC) / kDoubling_K));
  }

 private:
  std::optional<double> given_degC_;
  double share_;
};

}  // namespace

EffectEntry thermalNoise() {
  return {.info = {.name = "thermal-noise",
                   .title = "Thermal noise of the detector",
                   .summary =
                       "The detector's noise grows with its temperature: weak echoes are lost and values scatter more.",
                   .stage = Stage::kReception,
                   .percollect = {"58", "60", "63"},
                   .parameters = {{"temperature_degC", "°C", -40.0, 85.0, std::nullopt,
                                   "Temperature of the detector; without it the experiment's environment", false, 50.0},
                                  {"dark_share", "", 0.0, 1.0, 1.0,
                                   "Share of the noise variance at 20 °C that is dark noise", false, 1.0}},
                   .fitted = {"temperature_degC"},
                   .source = "Sze & Ng 2007, Physics of Semiconductor Devices, ch. 13"},
          .make = makeFrom<ThermalNoise>};
}

}  // namespace model::effects
