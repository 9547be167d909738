#include "metrics/area/double_metric.h"

#include "metrics/area/area_metric.h"

namespace metrics {

DoubleMetric doubleMetric(const Comparison& boxes) {
  const auto area = [](const Edf& simulated, const Edf& measured) {
    return areaValidationMetric({.simulated = simulated, .measured = measured});
  };
  return {.left = area(boxes.simulated.left(), boxes.measured.left()),
          .right = area(boxes.simulated.right(), boxes.measured.right())};
}

}  // namespace metrics
