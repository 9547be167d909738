#include <algorithm>
#include <array>
#include <cmath>

#include "core/bulk_math.h"
#include "model/effects/declarations.h"
#include "model/extinction.h"

namespace model::effects {

namespace {

/// Beer–Lambert, out and back: P = P_clear · exp(-2 α r).
class AtmosphericAttenuation final : public Effect {
 public:
  explicit AtmosphericAttenuation(const EffectParameters& parameters) : parameters_(parameters) {}

  void prepare(ChainSettings& settings, const Environment& environment) override {
    const double wavelength_nm = settings.emitter.wavelength_nm;
    if (!parameters_.numbers.empty()) {
      extinction_1_m_ =
          fromNumbers(parameters_.number("visibility_m"), parameters_.number("rain_rate_mm_h"), wavelength_nm) +
          parameters_.numberOr("extinction_1_m", 0.0);
    } else {
      extinction_1_m_ = fromNumbers(environment.visibility_m, environment.rain_rate_mm_h, wavelength_nm);
    }
  }
  [[nodiscard]] bool changesPower() const override { return true; }
  [[nodiscard]] double powerFactor(const Reflection& reflection) const override {
    return std::exp(-2.0 * extinction_1_m_ * reflection.range_m);
  }

  [[nodiscard]] bool weakensInBulk() const override { return true; }
  void weaken(const Returns& returns) const override {
    constexpr std::size_t kPiece = 512;
    std::array<double, kPiece> factor;
    for (std::size_t begin = 0; begin < returns.range_m.size(); begin += kPiece) {
      const std::size_t count = std::min(kPiece, returns.range_m.size() - begin);
      for (std::size_t i = 0; i < count; ++i) factor[i] = -2.0 * extinction_1_m_ * returns.range_m[begin + i];
      core::expOf(std::span(factor).first(count), factor);
      for (std::size_t i = 0; i < count; ++i) returns.power_w[begin + i] *= factor[i];
    }
  }

 private:
  static double fromNumbers(std::optional<double> visibility_m, std::optional<double> rain_rate_mm_h,
                            double wavelength_nm) {
    return (visibility_m ? extinctionFromVisibility(*visibility_m, wavelength_nm) : 0.0) +
           (rain_rate_mm_h ? extinctionFromRain(*rain_rate_mm_h) : 0.0);
  }

  EffectParameters parameters_;
  double extinction_1_m_ = 0.0;
};

}  // namespace

EffectEntry atmosphericAttenuation() {
  return {
      .info = {.name = "atmospheric-attenuation",
               .title = "Attenuation by the atmosphere",
               .summary = "Fog, haze or rain weaken the light on its way out and back: echoes from far away are "
                          "weaker, narrower, or lost.",
               .stage = Stage::kPropagation,
               .percollect = {"87", "92", "93", "98"},
               .parameters = {{"visibility_m", "m", 20.0, 20000.0, std::nullopt,
                               "Meteorological visibility; without any parameter the experiment's environment", true,
                               1000.0},
                              {"rain_rate_mm_h", "mm/h", 0.0, 100.0, std::nullopt, "Rain rate", false, 10.0},
                              {"extinction_1_m", "1/m", 0.0, 0.2, std::nullopt, "Extinction coefficient", true, 0.005}},
               .fitted = {"visibility_m"},
               .source = "Kruse et al. 1962; Kim et al. 2001, doi:10.1117/12.417512; Carbonneau & Wisely 1998, "
                         "doi:10.1117/12.302454"},
      .make = makeFrom<AtmosphericAttenuation>};
}

}  // namespace model::effects
