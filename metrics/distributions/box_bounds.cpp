#include "metrics/distributions/box_bounds.h"

#include <cmath>
#include <fmt/format.h>

#include "core/error.h"
#include "metrics/distributions/level_walk.h"

namespace metrics {

Interval quantileInterval(const PBox& box, double p) {
  if (!(p >= 0.0 && p <= 1.0)) {
    throw core::InputError({}, fmt::format("level {} has no quantile; a probability lies between 0 and 1.", p),
                           "Give a share: 0.95 for 95 %.");
  }
  return {.low = box.left().quantile(p), .high = box.right().quantile(p)};
}

Interval probabilityInterval(const PBox& box, double x) {
  if (std::isnan(x)) {
    throw core::InputError({}, "nan is no value to look up in a distribution.",
                           "Give a number in the unit of the box.");
  }
  return {.low = box.right().cdf(x), .high = box.left().cdf(x)};
}

Interval meanInterval(const PBox& box) { return {.low = box.left().mean(), .high = box.right().mean()}; }

bool contains(const PBox& outer, const PBox& inner) {
  bool inside = true;
  eachCommonLevel<4>({&outer.left(), &inner.left(), &inner.right(), &outer.right()}, [&](const CommonLevel<4>& at) {
    inside = inside && at.quantiles[0] <= at.quantiles[1] && at.quantiles[2] <= at.quantiles[3];
  });
  return inside;
}

}  // namespace metrics
