#include "model/material/oren_nayar.h"

#include "model/material/lambertian.h"

namespace model {

namespace {

constexpr double kSmallestCosine = 1e-6;  ///< tan θ is unbounded; the radar equation's cos θ makes up for it

struct Coefficients {
  double a;
  double b;
};

Coefficients coefficientsOf(double roughness_rad) {
  const double s = roughness_rad * roughness_rad;
  return {1.0 - 0.5 * s / (s + 0.33), 0.45 * s / (s + 0.09)};
}

}  // namespace

double OrenNayar::brdf(double reflectivity, const ReflectionAngles& angles) const {
  const auto [a, b] = coefficientsOf(roughness_rad);
  // sin of the larger angle times tan of the smaller: both sines over the larger cosine.
  const double sin_tan = angles.sinProduct() / std::max({angles.cos_in, angles.cos_out, kSmallestCosine});
  return lambertianBrdf(reflectivity) * (a + b * std::max(0.0, angles.cos_azimuth) * sin_tan);
}

double OrenNayar::monostaticFactor(double cos_incidence) const {
  const auto [a, b] = coefficientsOf(roughness_rad);
  const double c = std::max(cos_incidence, kSmallestCosine);
  return a + b * (1.0 - c * c) / c;
}

}  // namespace model
