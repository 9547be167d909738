#pragma once

#include <complex>

namespace model {

/// n + i k: refractive index and extinction coefficient (k >= 0 absorbs; metals have k of several).
using ComplexIndex = std::complex<double>;

/// Shares of the power for light polarised across (s) and in (p) the plane of incidence.
struct Polarised {
  double s = 0.0;
  double p = 0.0;
  [[nodiscard]] double unpolarised() const noexcept { return 0.5 * (s + p); }
};

/// Reflectance of a smooth surface seen from air, `index` on the other side.
///
///   r_s = (cos θ - ñ cos θ_t) / (cos θ + ñ cos θ_t),   r_p = (ñ cos θ - cos θ_t) / (ñ cos θ + cos θ_t),   R = |r|²
///   sin θ = ñ sin θ_t (complex with absorption)
///
/// Source: Born & Wolf, Principles of Optics, 7th ed., sec. 1.5.2 (dielectrics), 14.2 (metals).
[[nodiscard]] Polarised fresnelReflectance(double cos_incidence, ComplexIndex index);

/// A plane-parallel pane in air: all reflections to and fro between its faces are added up as powers (a pane is
/// thicker than the pulse is coherent). With R of one face and `a` of one way through the glass:
///
///   R_pane = R + (1-R)² R a² / (1 - R² a²),   T_pane = (1-R)² a / (1 - R² a²)
///
/// Without absorption R_pane + T_pane = 1. Source: Stokes 1862, Proc. R. Soc. 11, 545 (pile of plates).
struct Pane {
  ComplexIndex index{1.5, 0.0};
  double internal_transmittance = 1.0;  ///< one way at normal incidence, without the faces' reflections

  /// The pane through which `transmission` of the light passes at normal incidence. More than clear glass of this index
  /// lets pass cannot be: it is then clear glass.
  [[nodiscard]] static Pane ofTransmission(ComplexIndex index, double transmission);

  [[nodiscard]] Polarised reflectance(double cos_incidence) const;
  [[nodiscard]] Polarised transmittance(double cos_incidence) const;
};

/// Reflectance of a surface under diffuse light from all sides: ∫ R(θ) sin 2θ dθ over the hemisphere.
[[nodiscard]] double diffuseFresnelReflectance(ComplexIndex index);

}  // namespace model
