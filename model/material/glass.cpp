#include "model/material/glass.h"

#include "model/material/cook_torrance.h"
#include "model/material/lambertian.h"

namespace model {

double Glass::brdf(double reflectivity, const Pane& pane, const ReflectionAngles& angles) const {
  const double mirror = pane.reflectance(cosAtMirror(angles)).unpolarised();
  return lambertianBrdf(reflectivity) +
         (1.0 - reflectivity) * microfacetLobe(Microfacets::kBeckmann, roughness, mirror, angles);
}

}  // namespace model
