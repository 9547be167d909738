#pragma once

#include "model/material/reflection_angles.h"

namespace model {

/// Diffuse part plus a lobe around the mirror direction: painted metal, smooth plastics.
///
///   β = Γ · (k_d/π + (1 - k_d) (n+2)/(2π) · cos^n α)
///
///   k_d   share of the diffuse part, in [0, 1]
///   n     sharpness of the lobe, >= 0
///   α     angle to the mirror direction; 2θ seen from the sensor
///
/// Reciprocal; at normal incidence exactly Γ is reflected, less elsewhere (part of the lobe lies below the surface).
/// Source: Lafortune & Willems 1994, CW 197, eq. 9.
struct Phong {
  double diffuse_fraction = 1.0;
  double exponent = 1.0;

  [[nodiscard]] double brdf(double reflectivity, const ReflectionAngles& angles) const;
  /// Monostatic, over that of a Lambertian surface of the same reflectivity.
  [[nodiscard]] double monostaticFactor(double cos_incidence) const;
};

/// (n+2)/2 · cos^n α: a lobe of unit reflectance over Lambert's 1/π.
[[nodiscard]] double phongLobe(double exponent, double cos_to_mirror);

}  // namespace model
