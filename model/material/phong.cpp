#include "model/material/phong.h"

#include "model/material/lambertian.h"

namespace model {

double phongLobe(double exponent, double cos_to_mirror) {
  return (exponent + 2.0) / 2.0 * std::pow(std::max(0.0, cos_to_mirror), exponent);
}

double Phong::brdf(double reflectivity, const ReflectionAngles& angles) const {
  return lambertianBrdf(reflectivity) *
         (diffuse_fraction + (1.0 - diffuse_fraction) * phongLobe(exponent, angles.cosToMirror()));
}

double Phong::monostaticFactor(double cos_incidence) const {
  const double cos_mirror = 2.0 * cos_incidence * cos_incidence - 1.0;  // cos 2θ
  return diffuse_fraction + (1.0 - diffuse_fraction) * phongLobe(exponent, cos_mirror);
}

}  // namespace model
