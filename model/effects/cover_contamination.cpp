#include "core/physics.h"
#include "model/effects/declarations.h"

namespace model::effects {

namespace {

/// Dirt or drops on the window: sub-rays of a sector lose power on the way out and on the way in.
///   P = P_clean · (1 - attenuation)²
class CoverContamination final : public Effect {
 public:
  explicit CoverContamination(const EffectParameters& parameters)
      : factor_((1.0 - parameters.numberOr("attenuation", 0.3)) * (1.0 - parameters.numberOr("attenuation", 0.3))),
        from_rad_(parameters.numberOr("azimuth_from_deg", -180.0) * core::kRadPerDeg),
        to_rad_(parameters.numberOr("azimuth_to_deg", 180.0) * core::kRadPerDeg) {}

  [[nodiscard]] bool changesPower() const override { return true; }
  [[nodiscard]] double powerFactor(const Reflection& reflection) const override {
    const double azimuth_rad = reflection.azimuth_rad();
    return azimuth_rad >= from_rad_ && azimuth_rad <= to_rad_ ? factor_ : 1.0;
  }

 private:
  double factor_;
  double from_rad_;
  double to_rad_;
};

}  // namespace

EffectEntry coverContamination() {
  return {
      .info = {.name = "cover-contamination",
               .title = "Contamination of the sensor cover",
               .summary = "Dirt or drops on the sensor's window take light away in a part of the view.",
               .stage = Stage::kReception,
               .percollect = {"69"},
               .parameters = {{"attenuation", "", 0.0, 1.0, 0.3, "Share of power lost at each passage of the window",
                               false, 0.3},
                              {"azimuth_from_deg", "deg", -180.0, 180.0, -180.0, "Right end of the sector", false,
                               -20.0},
                              {"azimuth_to_deg", "deg", -180.0, 180.0, 180.0, "Left end of the sector", false, 20.0}},
               .fitted = {"attenuation", "azimuth_from_deg", "azimuth_to_deg"},
               .source = "Rivero et al. 2017, doi:10.1109/JSEN.2016.2629507"},
      .make = makeFrom<CoverContamination>};
}

}  // namespace model::effects
