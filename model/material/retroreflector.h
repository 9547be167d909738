#pragma once

#include "model/material/reflection_angles.h"

namespace model {

/// Glass beads and corner-cube prisms send the light back where it came from.
///
///   β = Γ/π · (1 + (g - 1) E(θ) · 2^-(δ/δ_h)²),     E(θ) = 2^-(θ/θ_h)²
///
///   g     return at normal incidence over that of a Lambertian of the same reflectivity Γ
///   θ_h   entrance angle at which the surplus has fallen to one half (`half_width_rad`)
///   δ     observation angle: between the ways out and back; 0 if sender and receiver are one
///   δ_h   observation angle of half the surplus
///
/// For two different angles to the normal E is the geometric mean, which keeps the BRDF reciprocal.
/// A sheet's coefficient of retroreflection R_A [cd/(lx m²)] gives g = π R_A / Γ. Beads are wide, prisms narrow: by the
/// minimum values of ASTM D4956 (0.2° and 0.5°, -4° and 30°), type I and III (beads) have θ_h = 0.47 and 0.60 rad,
/// δ_h = 0.0072 and 0.0068 rad; single corner cubes for surveying have δ_h far below a milliradian.
/// Source: ASTM E808-01 (geometry); Lloyd 2008, Retroreflection, ch. 2 (entrance angularity).
struct Retroreflector {
  double gain = 1.0;
  double half_width_rad = 0.5;
  double observation_half_width_rad = 0.007;

  [[nodiscard]] double brdf(double reflectivity, const ReflectionAngles& angles) const;
  /// Monostatic, over that of a Lambertian surface of the same reflectivity.
  [[nodiscard]] double monostaticFactor(double cos_incidence) const;
  /// What it reflects in all at normal incidence, as lobe and as Lambertian; above 1 there is no such surface.
  [[nodiscard]] double hemisphericalReflectance(double reflectivity) const;
};

}  // namespace model
