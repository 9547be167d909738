#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "model/material/reflection_angles.h"

namespace model::lab {

/// Where a BRDF is steep: directions are laid out densely around it.
enum class Around { kNormal, kMirror, kLight };

/// Share of the light at incidence `cos_in` that goes anywhere: ∫ β cos θ_out dω over the hemisphere, by the midpoint
/// rule in polar coordinates around an axis (angle ρ = π t³ to it). Good to 1e-3 for lobes down to a milliradian.
template <typename Brdf>
double reflectedShare(const Brdf& brdf, double cos_in, Around around) {
  constexpr int kRings = 400, kSteps = 360;
  using std::numbers::pi;
  const double sin_in = std::sqrt(1.0 - cos_in * cos_in);
  const double tilt = around == Around::kNormal ? 0.0 : std::acos(cos_in) * (around == Around::kLight ? 1.0 : -1.0);
  double sum = 0.0;
  for (int i = 0; i < kRings; ++i) {
    const double t = (i + 0.5) / kRings, rho = pi * t * t * t, d_rho = 3.0 * pi * t * t / kRings;
    for (int j = 0; j < kSteps; ++j) {
      const double phi = (j + 0.5) * 2.0 * pi / kSteps;
      // Around the axis, then tilted about y into the plane of incidence (the light comes from +x).
      const std::array<double, 3> local{std::sin(rho) * std::cos(phi), std::sin(rho) * std::sin(phi), std::cos(rho)};
      const double x = std::cos(tilt) * local[0] + std::sin(tilt) * local[2], y = local[1];
      const double z = -std::sin(tilt) * local[0] + std::cos(tilt) * local[2];
      if (z <= 0.0) continue;
      const double flat = std::hypot(x, y);
      const ReflectionAngles angles{cos_in, std::min(z, 1.0), flat > 0.0 && sin_in > 0.0 ? x / flat : 1.0};
      sum += brdf(angles) * z * std::sin(rho) * d_rho * 2.0 * pi / kSteps;
    }
  }
  return sum;
}

/// Largest relative difference after in and out have changed places.
template <typename Brdf>
double reciprocityError(const Brdf& brdf) {
  double worst = 0.0;
  for (const double in : {0.02, 0.3, 0.71, 1.0}) {
    for (const double out : {0.05, 0.5, 0.72, 0.99}) {
      for (const double azimuth : {-1.0, -0.4, 0.0, 0.7, 1.0}) {
        const double there = brdf(ReflectionAngles{in, out, azimuth}), back = brdf(ReflectionAngles{out, in, azimuth});
        if (there > 0.0 || back > 0.0) worst = std::max(worst, std::abs(there - back) / std::max(there, back));
      }
    }
  }
  return worst;
}

/// Cosines of incidence from grazing to normal.
inline constexpr double kIncidences[] = {0.05, 0.2, 0.5, 0.8, 0.95, 1.0};

[[nodiscard]] inline double cosOfDegrees(double deg) { return std::cos(deg * std::numbers::pi / 180.0); }

}  // namespace model::lab
