#pragma once

#include <optional>
#include <span>
#include <vector>

#include "model/sensor/sensor_profile.h"

namespace model {

/// How far a sensor sees, in closed form: a flat Lambertian surface of reflectivity Γ that fills the beam and stands
/// across it, at the azimuth where the emitter gives `gain` of its power.
///
///   P(r) = C Γ exp(-2 α r) / r²,   C = gain · P_t · η D² / 4         [W]
///   r    = W(α r₀) / α,            r₀ = sqrt(C Γ / P), r → r₀ for α → 0
///
/// W is Lambert's function, w exp(w) = x. Without overlap loss, backscatter and all other effects.
/// Source: laser radar equation (Rasshofer et al. 2011, doi:10.5194/ars-9-49-2011); Corless et al. 1996,
/// doi:10.1007/BF02124750 (W).
struct LinkTarget {
  double reflectivity = 0.1;
  double extinction_1_m = 0.0;
  double gain = 1.0;
};

/// Received peak power. [W]
[[nodiscard]] double receivedPower_w(const SensorProfile& sensor, const LinkTarget& target, double range_m);

/// Range at which that much is received. [m]
[[nodiscard]] double rangeOfPower_m(const SensorProfile& sensor, const LinkTarget& target, double power_w);

/// One line of the budget. The chain detects an echo of power P with probability Φ((P - threshold) / noise).
struct LinkBudgetRow {
  double reflectivity = 0.0;
  std::optional<double> visibility_m;  ///< none: clear air
  double half_m = 0.0;                 ///< detected in every second frame
  double sure_m = 0.0;                 ///< detected in 99 of 100 frames
};

/// Every reflectivity under every visibility. Not cut at max_range_m: the window is not physics.
[[nodiscard]] std::vector<LinkBudgetRow> linkBudget(const SensorProfile& sensor, std::span<const double> reflectivities,
                                                    std::span<const std::optional<double>> visibilities_m);

/// Noise crossings to expect in one beam between min_range_m and max_range_m, for Gaussian noise in a receiver matched
/// to the Gaussian pulse:
///
///   rate = exp(-T² / 2σ²) / (2π s),   s = FWHM / (2 sqrt(ln 2)) from the noise's correlation exp(-t² / 2s²)
///
/// A matched filter's noise is correlated as the pulse with itself, whose deviation is sqrt(2) of the pulse's.
/// Source: Rice 1945, Bell Syst. Tech. J. 24, sec. 3.3 (mean number of crossings of a level).
[[nodiscard]] double falseAlarmsPerBeam(const SensorProfile& sensor);

}  // namespace model
