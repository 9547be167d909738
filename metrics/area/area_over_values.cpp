#include "metrics/area/area_over_values.h"

#include <algorithm>

#include "metrics/distributions/summation.h"
#include "metrics/distributions/value_walk.h"

namespace metrics {

namespace {

/// int max(0, F(x) - G(x)) dx
double excess(const Edf& f, const Edf& g) {
  Summation sum;
  double last_x = 0.0;
  double height = 0.0;  // F - G since last_x; 0 before the first step
  eachCommonValue(f, g, [&](double x, double f_after, double g_after) {
    if (height > 0.0) sum.add(height * (x - last_x));
    last_x = x;
    height = f_after - g_after;
  });
  return sum.value();
}

}  // namespace

AreaPortions areaPortionsOverValues(const Comparison& boxes) {
  return {.d_plus = excess(boxes.simulated.right(), boxes.measured.left()),
          .d_minus = excess(boxes.measured.right(), boxes.simulated.left())};
}

}  // namespace metrics
