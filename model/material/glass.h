#pragma once

#include "model/material/fresnel.h"
#include "model/material/reflection_angles.h"

namespace model {

/// A smooth pane with some dust on it: nearly nothing comes back unless it is hit square on.
///
///   β = Γ/π + (1 - Γ) R_pane(θ_d) · D(θ_h) G / (4 cos θ_in cos θ_out)
///
///   Γ      the material's reflectivity: share of white dust and scratches on it, Lambertian
///   R_pane reflectance of the pane (fresnel.h); of its front face only where nothing is transmitted
///   D, G   microfacets with Gaussian slopes (cook_torrance.h) of a small roughness: waviness of the surface
///
/// Source: Walter et al. 2007 (EGSR), eq. 20; Born & Wolf sec. 1.5.2.
struct Glass {
  double roughness = 0.01;

  [[nodiscard]] double brdf(double reflectivity, const Pane& pane, const ReflectionAngles& angles) const;
};

}  // namespace model
