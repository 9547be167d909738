#include "metrics/area/area_metric.h"

#include <algorithm>

#include "metrics/distributions/level_walk.h"
#include "metrics/distributions/summation.h"

namespace metrics {

namespace {

/// int_0^1 max(0, upper(p) - lower(p) + offset) dp
double excess(const Edf& upper, const Edf& lower, double offset) {
  Summation sum;
  eachCommonLevel<2>({&upper, &lower}, [&](const CommonLevel<2>& at) {
    sum.add(at.width() * std::max(0.0, (at.quantiles[0] - at.quantiles[1]) + offset));
  });
  return sum.value();
}

}  // namespace

AreaPortions areaPortionsAfterShift(const Comparison& boxes, double shift) {
  return {.d_plus = excess(boxes.measured.left(), boxes.simulated.right(), shift),
          .d_minus = excess(boxes.simulated.left(), boxes.measured.right(), -shift)};
}

AreaPortions areaPortions(const Comparison& boxes) { return areaPortionsAfterShift(boxes, 0.0); }

double areaValidationMetric(const Comparison& boxes) { return areaPortions(boxes).area(); }

}  // namespace metrics
