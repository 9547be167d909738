#include <cmath>

#include "core/physics.h"
#include "model/effects/declarations.h"

namespace model::effects {

namespace {

/// Somebody catches the sensor's pulses and fires copies back, timed so that they seem to come from a surface: beams of
/// a sector receive one more pulse, in every frame at the same range and with the same power. It comes one way from its
/// own source, so its power has nothing to do with that range, and no surface hides it.
/// Source: Petit et al. 2015, Remote Attacks on Automated Vehicles Sensors, Black Hat Europe; Shin et al. 2017,
/// doi:10.1007/978-3-319-66787-4_22; Cao et al. 2019, doi:10.1145/3319535.3339815.
class Spoofing final : public Effect {
 public:
  explicit Spoofing(const EffectParameters& parameters)
      : azimuth_deg_(parameters.numberOr("azimuth_deg", 0.0)),
        width_deg_(parameters.numberOr("width_deg", 2.0)),
        pulse_{parameters.numberOr("range_m", 15.0), parameters.numberOr("power_w", 1e-6), false} {}

  [[nodiscard]] bool addsPulses() const override { return true; }
  void addPulses(const BeamView& view, std::vector<Pulse>& pulses) const override {
    const double off_deg = std::remainder(view.beam.azimuth_rad * core::kDegPerRad - azimuth_deg_, 360.0);
    if (std::abs(off_deg) <= width_deg_ / 2.0) pulses.push_back(pulse_);
  }

 private:
  double azimuth_deg_;
  double width_deg_;
  Pulse pulse_;
};

}  // namespace

EffectEntry spoofing() {
  return {
      .info = {.name = "spoofing",
               .title = "Spoofing by relayed pulses",
               .summary = "Somebody sends pulses back on purpose: a target appears that does not exist.",
               .stage = Stage::kPropagation,
               .percollect = {"82"},
               .parameters = {{"azimuth_deg", "deg", -180.0, 180.0, 0.0, "Middle of the sector", false, 0.0},
                              {"range_m", "m", 0.0, 300.0, 15.0, "Where the false target seems to stand", false, 15.0},
                              {"width_deg", "deg", 0.01, 360.0, 2.0, "Width of the sector", true, 2.0},
                              {"power_w", "W", 1e-10, 1e-3, 1e-6, "Received peak power of the relayed pulses", true,
                               1e-6}},
               .fitted = {"azimuth_deg", "range_m", "width_deg"},
               .source = "Petit et al. 2015, Black Hat Europe; Shin et al. 2017, doi:10.1007/978-3-319-66787-4_22; Cao "
                         "et al. 2019, doi:10.1145/3319535.3339815"},
      .make = makeFrom<Spoofing>};
}

}  // namespace model::effects
