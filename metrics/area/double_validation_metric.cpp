#include "metrics/area/double_validation_metric.h"

#include <algorithm>
#include <vector>

#include "metrics/distributions/level_walk.h"

namespace metrics {

namespace {

/// The shifts at which a quantile begins or ceases to be covered: where the slope of g changes.
std::vector<double> breakPoints(const Comparison& boxes) {
  std::vector<double> points;
  const auto add = [&points](const CommonLevel<2>& at) { points.push_back(at.quantiles[0] - at.quantiles[1]); };
  eachCommonLevel<2>({&boxes.simulated.left(), &boxes.measured.right()}, add);
  eachCommonLevel<2>({&boxes.simulated.right(), &boxes.measured.left()}, add);
  return points;
}

/// A shift and the bias that it leaves.
struct Point {
  double shift;
  double bias;
};

}  // namespace

double balancedShift(const Comparison& boxes) {
  if (boxes.simulated.isSingleDistribution() && boxes.measured.isSingleDistribution()) {
    return areaPortions(boxes).bias();  // g falls with slope 1 throughout
  }
  const auto at = [&](double shift) {
    return Point{.shift = shift, .bias = areaPortionsAfterShift(boxes, shift).bias()};
  };
  const Point start = at(0.0);
  if (start.bias == 0.0) return 0.0;
  const bool too_high = start.bias > 0.0;

  // `near` still has bias of the first sign, `far` has none or the other: the root lies between. Among several roots
  // (the box covers the measurement over a stretch of shifts) the one nearest to 0 is wanted.
  const auto stillBiased = [too_high](const Point& point) { return too_high ? point.bias > 0.0 : point.bias < 0.0; };
  std::vector<double> points = breakPoints(boxes);
  std::erase_if(points, [too_high](double b) { return too_high ? b <= 0.0 : b >= 0.0; });
  const auto nearer = [too_high](double a, double b) { return too_high ? a < b : a > b; };
  Point near = start;
  Point far = start;
  bool bracketed = false;
  while (!points.empty()) {
    const auto middle = points.begin() + static_cast<std::ptrdiff_t>(points.size() / 2);
    std::nth_element(points.begin(), middle, points.end(), nearer);
    const double pivot = *middle;
    const Point point = at(pivot);
    if (stillBiased(point)) {
      near = point;
      std::erase_if(points, [&](double b) { return !nearer(pivot, b); });
    } else {
      far = point;
      bracketed = true;
      std::erase_if(points, [&](double b) { return !nearer(b, pivot); });
    }
  }
  // Rounding may leave the last break point biased by some 1e-16; then it is the root.
  if (!bracketed || near.bias == far.bias) return near.shift;
  return near.shift + (far.shift - near.shift) * (near.bias / (near.bias - far.bias));
}

DoubleValidation doubleValidationMetric(const Comparison& boxes, Shift shift) {
  const double bias = shift == Shift::One ? areaPortions(boxes).bias() : balancedShift(boxes);
  const AreaPortions rest = areaPortionsAfterShift(boxes, bias);
  return {.bias = bias, .scatter = rest.area(), .residual = rest.bias()};
}

}  // namespace metrics
