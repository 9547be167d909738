#pragma once

#include "model/material/fresnel.h"
#include "model/material/reflection_angles.h"

namespace model {

/// How the slopes of the tiny mirrors are distributed.
enum class Microfacets {
  kGgx,       ///< long tails: ground glass, worn paint
  kBeckmann,  ///< Gaussian slopes: polished and machined surfaces
};

/// Rough reflecting surface of tiny mirrors, plus a diffuse part: car paint, bare metal, coated plastics.
///
///   β = d Γ/π + (1 - d) F(θ_d) D(θ_h) G / (4 cos θ_in cos θ_out)
///
///   d     share of the diffuse part, in [0, 1]
///   h     the direction halfway between in and out; θ_h its angle to the normal, θ_d that to `in`
///   F     Fresnel reflectance of the material's (complex) index; seen from the sensor it is that at normal incidence
///   D     density of mirrors that face h, with roughness α: sqrt(2) times the standard deviation of the slopes
///   G     share of them that is neither in shadow nor hidden; seen from the sensor what is lit is also seen
///
/// F, D, G: Walter et al. 2007 (EGSR), eq. 20, 25, 33 and for Smith's shadowing the exact integrals behind eq. 26, 34.
/// Shadowing and hiding are correlated over the azimuth: van Ginneken et al. 1998, doi:10.1364/AO.37.000130.
/// Source of the idea: Cook & Torrance 1982, doi:10.1145/357290.357293. Light that is reflected twice is lost.
struct CookTorrance {
  double roughness = 0.1;
  double diffuse_fraction = 0.0;
  Microfacets microfacets = Microfacets::kGgx;

  [[nodiscard]] double brdf(double reflectivity, ComplexIndex index, const ReflectionAngles& angles) const;
};

/// F D G / (4 cos θ_in cos θ_out) for a reflectance F of the single mirror. [1/sr]
[[nodiscard]] double microfacetLobe(Microfacets microfacets, double roughness, double mirror_reflectance,
                                    const ReflectionAngles& angles);

/// Angle between the direction halfway between in and out, and either of them; 1 if monostatic. [cosine]
[[nodiscard]] double cosAtMirror(const ReflectionAngles& angles);

}  // namespace model
