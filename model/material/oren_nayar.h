#pragma once

#include "model/material/reflection_angles.h"

namespace model {

/// Rough diffuse surface: V-shaped grooves with Lambertian facets shade and hide one another.
///
///   β = Γ/π · (A + B max(0, cos φ) sin α tan β'),   A = 1 - 0.5 σ²/(σ²+0.33),   B = 0.45 σ²/(σ²+0.09)
///
///   σ       standard deviation of the facets' slope angle, 0 is Lambertian       [rad]
///   α, β'   the larger and the smaller of incidence and exit angle;  φ azimuth between them
///
/// Seen from where the light comes it falls off more slowly than Lambert's surface: A + B sin θ tan θ grows with θ.
/// The approximation does not conserve energy exactly: for Γ = 1 the hemisphere gives up to 1.6 % too much at grazing
/// incidence (its limit there is A + B/2). Interreflections between facets are left out.
/// Source: Oren & Nayar 1994, doi:10.1145/192161.192213, eq. 30.
struct OrenNayar {
  double roughness_rad = 0.0;

  [[nodiscard]] double brdf(double reflectivity, const ReflectionAngles& angles) const;
  /// Monostatic, over that of a Lambertian surface of the same reflectivity.
  [[nodiscard]] double monostaticFactor(double cos_incidence) const;
};

}  // namespace model
