#pragma once

#include "bench/withheld/generator/effects.h"
#include "bench/withheld/generator/scene.h"

namespace withheld {

/// What surfaces do with a ray that comes back the way it went. Without effects every surface is Lambertian and opaque.
///
/// On purpose not the usual forms:
/// - Oren–Nayar with all terms, C1, C2, C3 and the interreflections (Oren & Nayar 1994, doi:10.1145/192161.192213, eq.
/// 27–30);
/// - the glossy lobe over the half vector, cos^4n θ (4n+8)/8π in place of cos^n 2θ (n+2)/2π: the same peak and, near
/// it, the
///   same width (Blinn 1977, doi:10.1145/563858.563893);
/// - wet surfaces after Ångström 1925 (Geogr. Ann. 7, 323): light scattered into a film is partly kept there by total
///   reflection, Γ_wet = Γ / (Γ + n²(1 − Γ)), and the film adds a lobe of its Fresnel reflectance;
/// - retroreflectors fall off as a power of cos θ.
class Surfaces {
 public:
  explicit Surfaces(const Effects& effects) : effects_(effects) {}

  /// β(θ) back to the sensor. [1/sr]
  [[nodiscard]] double backward(const Material& material, double cosine) const;
  /// Share of the power that passes once. Beer–Lambert along the slanted path and Fresnel's losses at both faces.
  [[nodiscard]] double passing(const Material& material, double cosine) const;
  /// Share of the power that is mirrored once.
  [[nodiscard]] double mirrored(const Material& material) const;

 private:
  [[nodiscard]] Material asItIs(const Material& material) const;

  const Effects& effects_;
};

/// Unpolarised Fresnel reflectance of a face into index n. Born & Wolf, sec. 1.5.2.
[[nodiscard]] double fresnel(double cosine, double index);

}  // namespace withheld
