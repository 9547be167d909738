#include "model/material/cook_torrance.h"

#include <numbers>

#include "model/material/lambertian.h"

namespace model {

namespace {

constexpr double kSmallestCosine = 1e-6;  ///< β grows without bound at grazing angles

/// Density of microfacets per solid angle; ∫ D cos θ_h dω = 1.
double density(Microfacets microfacets, double roughness, double cos_half) {
  const double a2 = roughness * roughness, c2 = cos_half * cos_half;
  if (c2 <= 0.0) return 0.0;
  if (microfacets == Microfacets::kBeckmann) {
    return std::exp(-(1.0 - c2) / (c2 * a2)) / (std::numbers::pi * a2 * c2 * c2);
  }
  const double bracket = c2 * (a2 - 1.0) + 1.0;
  return a2 / (std::numbers::pi * bracket * bracket);
}

/// Share of the microfacets that one direction sees (Smith).
double visible(Microfacets microfacets, double roughness, double cosine) {
  const double tangent = std::sqrt(std::max(0.0, 1.0 - cosine * cosine)) / cosine;
  if (tangent <= 0.0) return 1.0;
  if (microfacets == Microfacets::kGgx) {
    return 2.0 / (1.0 + std::sqrt(1.0 + roughness * roughness * tangent * tangent));
  }
  const double a = 1.0 / (roughness * tangent);
  return 2.0 / (1.0 + std::erf(a) + std::exp(-a * a) / (a * std::sqrt(std::numbers::pi)));
}

/// Lit and seen: the smaller of both if the directions coincide, independent of each other if they are far apart.
double litAndSeen(Microfacets microfacets, double roughness, const ReflectionAngles& angles, double c_in,
                  double c_out) {
  const double in = visible(microfacets, roughness, c_in), out = visible(microfacets, roughness, c_out);
  const double azimuth = std::acos(std::clamp(angles.cos_azimuth, -1.0, 1.0));
  const double independence = 4.41 * azimuth / (4.41 * azimuth + 1.0);
  return independence * in * out + (1.0 - independence) * std::min(in, out);
}

}  // namespace

double cosAtMirror(const ReflectionAngles& angles) { return std::sqrt(0.5 * (1.0 + angles.cosBetween())); }

double microfacetLobe(Microfacets microfacets, double roughness, double mirror_reflectance,
                      const ReflectionAngles& angles) {
  const double c_in = std::max(angles.cos_in, kSmallestCosine), c_out = std::max(angles.cos_out, kSmallestCosine);
  const double at_mirror = cosAtMirror(angles);
  if (at_mirror <= 0.0) return 0.0;
  const double cos_half = std::min(1.0, (c_in + c_out) / (2.0 * at_mirror));
  return mirror_reflectance * density(microfacets, roughness, cos_half) *
         litAndSeen(microfacets, roughness, angles, c_in, c_out) / (4.0 * c_in * c_out);
}

double CookTorrance::brdf(double reflectivity, ComplexIndex index, const ReflectionAngles& angles) const {
  const double mirror = fresnelReflectance(cosAtMirror(angles), index).unpolarised();
  return diffuse_fraction * lambertianBrdf(reflectivity) +
         (1.0 - diffuse_fraction) * microfacetLobe(microfacets, roughness, mirror, angles);
}

}  // namespace model
