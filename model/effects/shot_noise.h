#pragma once

#include "model/sensor/sensor_profile.h"

namespace model::effects {

/// Variance that light of constant power adds to the noise, input-referred. [W²]
///
///   σ² = 2 (h c/λ) P B,   B = 0.44 / FWHM
///
/// Every detected photon counts with its energy; quantum efficiency stands in P.
/// Source: Gagliardi & Karp 1995, Optical Communications, ch. 2.
[[nodiscard]] inline double shotNoise_w2(const Emitter& emitter, double power_w) {
  constexpr double kPlanckTimesLight_J_m = 1.98644586e-25;
  const double photon_J = kPlanckTimesLight_J_m / (emitter.wavelength_nm * 1e-9);
  const double bandwidth_hz = 0.44 / (emitter.pulse_fwhm_ns * 1e-9);
  return 2.0 * photon_J * power_w * bandwidth_hz;
}

}  // namespace model::effects
