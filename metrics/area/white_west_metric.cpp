#include "metrics/area/white_west_metric.h"

namespace metrics {

AreaPortions whiteWestPortions(const Comparison& boxes) {
  const auto between = [](const Edf& simulated, const Edf& measured) {
    return areaPortions({.simulated = simulated, .measured = measured});
  };
  return {.d_plus = between(boxes.simulated.right(), boxes.measured.right()).d_plus,
          .d_minus = between(boxes.simulated.left(), boxes.measured.left()).d_minus};
}

}  // namespace metrics
