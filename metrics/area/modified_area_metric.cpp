#include "metrics/area/modified_area_metric.h"

#include <cmath>
#include <fmt/format.h>

#include "core/error.h"

namespace metrics {

double safetyFactor(double experiments) {
  if (!(experiments > 0.0) || !std::isfinite(experiments)) {
    throw core::InputError({}, fmt::format("{} experiments; the safety factor needs at least one.", experiments),
                           "Give the number of replications of the experiment.");
  }
  constexpr double kManyExperiments = 1.25;
  constexpr double kFewExperiments = 4.0;
  return kManyExperiments + 1.2 * (kFewExperiments - kManyExperiments) / std::cbrt(experiments);
}

ModifiedArea modifiedAreaMetric(const AreaPortions& portions, double experiments) {
  const double centre = -0.5 * portions.bias();
  const double half_width = safetyFactor(experiments) * 0.5 * portions.area();
  return {.lower = centre - half_width, .upper = centre + half_width};
}

}  // namespace metrics
