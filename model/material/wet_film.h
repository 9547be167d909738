#pragma once

#include "model/material/reflection_angles.h"

namespace model {

/// A water film makes a rough surface darker and gives it a specular lobe. Wet, with Γ the dry reflectivity:
///
///   diffuse   Γ_wet = (1 - F)(1 - p) Γ / (1 - p Γ)      light is trapped under the film and absorbed
///   specular  F (n+2)/2 cos^n α                         α angle to the mirror direction, 2θ from the sensor
///
///   F = 0.02    Fresnel reflectance from air to water (index 1.33) at normal incidence; 0.012 to 0.035 for liquids and
///               ice of index 1.25 to 1.45
///   p = 0.472   share of the diffuse light that the film throws back inside: 1 - (1 - 0.066)/1.33²; Ångström, without
///               the 0.066 of light from all sides, has 0.435, so how dark a lobe makes the rest is not known to a
///               fifth
///   n           sharpness of the lobe: a film follows rough ground and is as flat as that, which no formula says
///
/// `wetness` mixes dry (0) and closed film (1): the share of the area that is covered.
/// Absorption in the water is left out: a millimetre takes less than 1 % at 905 nm, but half at 1550 nm (Hale & Querry
/// 1973); films are far thinner, puddles are not.
/// Source: Lekner & Dorf 1988, doi:10.1364/AO.27.001278 (after Ångström 1925).
struct WetFilm {
  static constexpr double kLobeExponent = 100.0;  ///< of a film whose n nobody knows
  static constexpr double kReflectance = 0.02;

  double wetness = 0.0;
  double lobe_exponent = kLobeExponent;  ///< n
  double reflectance = kReflectance;     ///< F

  /// Reflectivity of the diffuse part under a closed film.
  [[nodiscard]] static double diffuseUnderFilm(double dry_reflectivity, double reflectance = kReflectance);
  /// What the film makes of a Lambertian surface. [1/sr]
  [[nodiscard]] double brdf(double dry_reflectivity, const ReflectionAngles& angles) const;
  /// Monostatic return over that of the dry surface; 1 for a black one.
  [[nodiscard]] double monostaticFactor(double dry_reflectivity, double cos_incidence) const;
};

}  // namespace model
