#include <cmath>
#include <numbers>

#include "core/physics.h"
#include "model/effects/declarations.h"
#include "model/effects/shot_noise.h"

namespace model::effects {

namespace {

/// A foreign light of the sensor's own wavelength shines into the receiver, in a sector of azimuths.
///
///   P_f = E A_r η                          its power on the detector
///   σ²  = σ_0² + 2 (h c/λ) P_f B           shot noise (shot_noise.h)
///   P_s = P_s0 · (1 - E / E_s)             what is left of the receiver's range below saturation
///   P   = P_clear · (1 - g)                what a gain that gives way under the light's current leaves of echoes
///
/// From E_s on nothing is left: every echo of the beam is lost (blinded). The sector stands for the receiver's stray
/// light as well, so it may be much wider than its field of view.
/// Source: Petit et al. 2015, Remote Attacks on Automated Vehicles Sensors, Black Hat Europe; Shin et al. 2017,
/// doi:10.1007/978-3-319-66787-4_22 (saturation of lidars by light); Melchior & Lynch 1966, IEEE Trans. Electron
/// Devices 13, 829 (an avalanche photodiode's gain falls with the current, which takes some of its voltage away).
class Blinding final : public Effect {
 public:
  explicit Blinding(const EffectParameters& parameters)
      : azimuth_deg_(parameters.numberOr("azimuth_deg", 0.0)),
        width_deg_(parameters.numberOr("width_deg", 5.0)),
        irradiance_w_m2_(parameters.numberOr("irradiance", 1.0)),
        share_of_saturation_(irradiance_w_m2_ / parameters.numberOr("saturation_irradiance", 10.0)),
        gain_left_(1.0 - parameters.numberOr("gain_loss", 0.0)) {}

  void prepare(ChainSettings& settings, const Environment&) override {
    const double diameter_m = settings.receiver.aperture_diameter_m;
    const double power_w =
        irradiance_w_m2_ * std::numbers::pi / 4.0 * diameter_m * diameter_m * settings.receiver.efficiency;
    noise_w2_ = shotNoise_w2(settings.emitter, power_w);
  }
  [[nodiscard]] bool changesReceiver() const override { return irradiance_w_m2_ > 0.0; }
  [[nodiscard]] bool changesPower() const override { return gain_left_ < 1.0; }
  [[nodiscard]] double powerFactor(const Reflection& reflection) const override {
    return inSector(reflection.azimuth_rad()) ? gain_left_ : 1.0;
  }
  void receive(const Beam& beam, Receiver& receiver) const override {
    if (!inSector(beam.azimuth_rad)) return;
    receiver.noise_w = std::sqrt(receiver.noise_w * receiver.noise_w + noise_w2_);
    if (share_of_saturation_ >= 1.0) {
      receiver.saturation_w = 0.0;
    } else if (receiver.saturation_w) {
      *receiver.saturation_w *= 1.0 - share_of_saturation_;
    }
  }
  [[nodiscard]] bool changesEchoes() const override { return share_of_saturation_ >= 1.0; }
  void process(Echo& echo, const Receiver& receiver, const ChainSettings&) const override {
    if (receiver.saturation_w && *receiver.saturation_w <= 0.0) echo.fate = Fate::kBlinded;
  }
  // Nothing to add; but those who report do so behind this effect, and must not see what it has lost.
  [[nodiscard]] bool reports() const override { return share_of_saturation_ >= 1.0; }

 private:
  [[nodiscard]] bool inSector(double azimuth_rad) const {
    const double off_deg = std::remainder(azimuth_rad * core::kDegPerRad - azimuth_deg_, 360.0);
    return std::abs(off_deg) <= width_deg_ / 2.0;
  }

  double azimuth_deg_;
  double width_deg_;
  double irradiance_w_m2_;
  double share_of_saturation_;
  double gain_left_;
  double noise_w2_ = 0.0;
};

}  // namespace

EffectEntry blinding() {
  return {
      .info = {.name = "blinding",
               .title = "Blinding by foreign light",
               .summary =
                   "Foreign light from one direction overloads the receiver, which measures little or nothing there.",
               .stage = Stage::kPropagation,
               .percollect = {"83"},
               .parameters = {{"azimuth_deg", "deg", -180.0, 180.0, 0.0, "Middle of the sector", false, 0.0},
                              {"irradiance", "W/m²", 0.0, 1000.0, 1.0,
                               "Irradiance of the foreign light at the receiver, within its optical band", true, 1.0},
                              {"width_deg", "deg", 0.01, 360.0, 5.0, "Width of the sector", true, 5.0},
                              {"saturation_irradiance", "W/m²", 0.01, 1000.0, 10.0,
                               "Irradiance from which the receiver sees nothing any more", true, 10.0},
                              {"gain_loss", "", 0.0, 1.0, 0.0, "Share of the receiver's gain that the light takes",
                               false, 0.3}},
               .fitted = {"azimuth_deg", "irradiance", "width_deg"},
               .other_forms = {{"desensitised", {"azimuth_deg", "irradiance", "width_deg", "gain_loss"}}},
               .source = "Petit et al. 2015, Black Hat Europe; Shin et al. 2017, "
                         "doi:10.1007/978-3-319-66787-4_22"},
      .make = makeFrom<Blinding>};
}

}  // namespace model::effects
