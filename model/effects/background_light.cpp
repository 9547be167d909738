#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/effects/declarations.h"

namespace model::effects {

namespace {

constexpr double kPlanckTimesLight_J_m = 1.98644586e-25;
constexpr double kSceneReflectivity = 0.3;  ///< of what the field of view sees on the average
constexpr double kFilterWidth_nm = 20.0;    ///< optical band pass

/// Shot noise of sunlight that the scene reflects into the receiver; it adds to the receiver's noise in quadrature.
///
///   P_b = E_λ Δλ · ρ/π · A_r Ω η        background power in the field of view Ω
///   σ²  = σ_0² + 2 (h c/λ) P_b B,   B = 0.44 / FWHM
///
/// Every detected photon counts with its energy; quantum efficiency stands in η. Light from near the sun's own
/// direction is not told apart, for the noise is one number a sensor. Source: Gagliardi & Karp 1995, Optical
/// Communications, ch. 2; Rasshofer et al. 2011, doi:10.5194/ars-9-49-2011.
class BackgroundLight final : public Effect {
 public:
  explicit BackgroundLight(const EffectParameters& parameters) : irradiance_(parameters.number("irradiance_w_m2_nm")) {}

  void prepare(ChainSettings& settings, const Environment& environment) override {
    const double irradiance = irradiance_.value_or(environment.background_irradiance_w_m2_nm.value_or(0.0));
    Receiver& receiver = settings.receiver;
    const AngularSize& view =
        receiver.field_of_view.horizontal_rad > 0.0 ? receiver.field_of_view : settings.emitter.divergence;
    const double aperture_m2 = std::numbers::pi / 4.0 * receiver.aperture_diameter_m * receiver.aperture_diameter_m;
    const double power_w = irradiance * kFilterWidth_nm * kSceneReflectivity / std::numbers::pi * aperture_m2 *
                           view.horizontal_rad * view.vertical_rad * receiver.efficiency;
    const double photon_J = kPlanckTimesLight_J_m / (settings.emitter.wavelength_nm * 1e-9);
    const double bandwidth_hz = 0.44 / (settings.emitter.pulse_fwhm_ns * 1e-9);
    receiver.noise_w = std::sqrt(receiver.noise_w * receiver.noise_w + 2.0 * photon_J * power_w * bandwidth_hz);
  }

 private:
  std::optional<double> irradiance_;
};

}  // namespace

EffectEntry backgroundLight() {
  return {.info = {.name = "background-light",
                   .title = "Shot noise of background light",
                   .stage = Stage::kReception,
                   .percollect = {"86", "90", "91", "99", "101", "143"},
                   .parameters = {{"irradiance_w_m2_nm", "W/(m² nm)", 0.0, 1.0, std::nullopt,
                                   "Spectral irradiance of the scene; without it the experiment's environment", false,
                                   0.5}},
                   .fitted = {"irradiance_w_m2_nm"},
                   .source = "Gagliardi & Karp 1995; Rasshofer et al. 2011, doi:10.5194/ars-9-49-2011"},
          .make = makeFrom<BackgroundLight>};
}

}  // namespace model::effects
