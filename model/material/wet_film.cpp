#include "model/material/wet_film.h"

#include "model/material/lambertian.h"
#include "model/material/phong.h"

namespace model {

namespace {

constexpr double kReflectedInside = 0.472;

}  // namespace

double WetFilm::diffuseUnderFilm(double dry_reflectivity, double reflectance) {
  return (1.0 - reflectance) * (1.0 - kReflectedInside) * dry_reflectivity /
         (1.0 - kReflectedInside * dry_reflectivity);
}

double WetFilm::brdf(double dry_reflectivity, const ReflectionAngles& angles) const {
  const double wet = lambertianBrdf(diffuseUnderFilm(dry_reflectivity, reflectance)) +
                     lambertianBrdf(reflectance) * phongLobe(lobe_exponent, angles.cosToMirror());
  return (1.0 - wetness) * lambertianBrdf(dry_reflectivity) + wetness * wet;
}

double WetFilm::monostaticFactor(double dry_reflectivity, double cos_incidence) const {
  if (dry_reflectivity <= 0.0) return 1.0;
  return brdf(dry_reflectivity, ReflectionAngles::monostatic(cos_incidence)) / lambertianBrdf(dry_reflectivity);
}

}  // namespace model
