#include "model/material/retroreflector.h"

#include <numbers>

#include "model/material/lambertian.h"

namespace model {

namespace {

/// 1 in the middle, one half where `angle` is the half width.
double bell(double angle, double half_width) {
  const double x = angle / half_width;
  return std::exp2(-x * x);
}

double angleOf(double cosine) { return std::acos(std::clamp(cosine, 0.0, 1.0)); }

}  // namespace

double Retroreflector::brdf(double reflectivity, const ReflectionAngles& angles) const {
  const double entrance =
      std::sqrt(bell(angleOf(angles.cos_in), half_width_rad) * bell(angleOf(angles.cos_out), half_width_rad));
  const double observation = std::acos(angles.cosBetween());
  return lambertianBrdf(reflectivity) * (1.0 + (gain - 1.0) * entrance * bell(observation, observation_half_width_rad));
}

double Retroreflector::monostaticFactor(double cos_incidence) const {
  return 1.0 + (gain - 1.0) * bell(angleOf(cos_incidence), half_width_rad);
}

double Retroreflector::hemisphericalReflectance(double reflectivity) const {
  // ∫ 2^-(δ/δ_h)² 2π δ dδ = π δ_h² / ln 2, small angles.
  const double lobe = observation_half_width_rad * observation_half_width_rad / std::numbers::ln2;
  return reflectivity * (1.0 + (gain - 1.0) * lobe);
}

}  // namespace model
