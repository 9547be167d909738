#include "metrics/area/signed_scatter.h"

#include <algorithm>

#include "metrics/area/area_metric.h"
#include "metrics/distributions/level_walk.h"
#include "metrics/distributions/summation.h"

namespace metrics {

namespace {

/// int sign(p - 1/2) dp over a level: the median may lie within it.
double weightOf(const CommonLevel<4>& at) {
  const double lower = std::min(at.level, 0.5) - std::min(at.below, 0.5);
  const double upper = std::max(at.level, 0.5) - std::max(at.below, 0.5);
  return upper - lower;
}

}  // namespace

double signedScatterAfterShift(const Comparison& boxes, double bias) {
  Summation sum;
  eachCommonLevel<4>(
      {&boxes.simulated.left(), &boxes.simulated.right(), &boxes.measured.left(), &boxes.measured.right()},
      [&](const CommonLevel<4>& at) {
        const auto& [sim_left, sim_right, real_left, real_right] = at.quantiles;
        const double too_high = std::max(0.0, (sim_left - real_right) - bias);
        const double too_low = std::max(0.0, (real_left - sim_right) + bias);
        sum.add(weightOf(at) * (too_high - too_low));
      });
  return sum.value();
}

double signedScatter(const Comparison& boxes, Shift shift) {
  return signedScatterAfterShift(boxes, shift == Shift::One ? areaPortions(boxes).bias() : balancedShift(boxes));
}

}  // namespace metrics
