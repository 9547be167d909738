#include "metrics/area/area_metric.h"

#include <algorithm>
#include <array>

#include "metrics/distributions/level_walk.h"

namespace metrics {

namespace {

/// int_0^1 max(0, upper(p) - lower(p) + offset) dp
double excess(const Edf& upper, const Edf& lower, double offset) {
  return levelIntegrals<1>(
      upper, lower, [offset](double high, double low) { return std::array{std::max(0.0, (high - low) + offset)}; })[0];
}

}  // namespace

AreaPortions areaPortionsAfterShift(const Comparison& boxes, double shift) {
  if (boxes.measured.isSingleDistribution() && boxes.simulated.isSingleDistribution()) {  // both in one pass
    const auto [d_plus, d_minus] =
        levelIntegrals<2>(boxes.measured.left(), boxes.simulated.left(), [shift](double measured, double simulated) {
          const double difference = (measured - simulated) + shift;
          return std::array{std::max(0.0, difference), std::max(0.0, -difference)};
        });
    return {.d_plus = d_plus, .d_minus = d_minus};
  }
  return {.d_plus = excess(boxes.measured.left(), boxes.simulated.right(), shift),
          .d_minus = excess(boxes.simulated.left(), boxes.measured.right(), -shift)};
}

AreaPortions areaPortions(const Comparison& boxes) { return areaPortionsAfterShift(boxes, 0.0); }

double areaValidationMetric(const Comparison& boxes) { return areaPortions(boxes).area(); }

}  // namespace metrics
