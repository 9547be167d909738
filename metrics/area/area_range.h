#pragma once

#include <cstddef>

#include "metrics/distributions/comparison.h"

namespace metrics {

/// In the unit of the measurand.
struct AreaRange {
  double smallest;  ///< exact
  double largest;
  double error;  ///< the true largest lies within largest -+ error; 0: exact
};

/// All that the area between simulation and measurement may be: over every distribution S in the simulated and every
/// M in the measured box, the smallest and the largest of
///
///   int_0^1 |q_S(p) - q_M(p)| dp
///
/// What is epistemic leaves the interval open; a single distribution on both sides closes it. Every value between the
/// ends is taken, too: weighted means of two rising quantiles rise and lead from one pair to the other without a jump.
///
/// The smallest is the area validation metric, and is reached: with m(p) = max(L_sim, L_real), the quantiles
/// min(m, R_sim) and min(m, R_real) rise, lie in their boxes, and are as near to each other as the boxes permit.
///
/// The largest is searched for over pairs of edge values. That is exact for the reasons given in
/// largest_area_metric.h, as |q_S - q_M| is convex in both: within a level it is nowhere larger than at a corner of the
/// rectangle that the two rising quantiles span, and a corner of two polytopes at once is a corner of each. It takes
/// time levels x (edge values inside one box) x (inside the other), or linear time if the larger of R_sim - L_real and
/// R_real - L_sim at each level gives rising quantiles. If that is more than `limit` steps, all values are rounded to
/// the finest grid that keeps to it; both quantiles move by half its step at most, so its step bounds the error.
///
/// If the measurement is a single distribution, `largest` is that of largestAreaMetric; otherwise it is not smaller,
/// for there the measurement takes the nearest part of its box and here the farthest.
/// Source: this project; the smallest is Ferson's (area_metric.h).
[[nodiscard]] AreaRange areaRange(const Comparison& boxes, std::size_t limit = 50'000'000);

}  // namespace metrics
