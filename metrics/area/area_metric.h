#pragma once

#include "metrics/distributions/comparison.h"

namespace metrics {

/// The two parts of the area between simulation and measurement, both >= 0. [unit of the measurand]
///
///   p 1 |          _____---
///       |   sim __|/d- /          d+  simulated CDF above the measured one: simulated values too small
///       |     _|d+|___/           d-  simulated CDF below the measured one: simulated values too large
///     0 |____|__/ real
///        ------------------ x
struct AreaPortions {
  double d_plus;
  double d_minus;

  [[nodiscard]] double area() const noexcept { return d_plus + d_minus; }
  /// > 0: simulated values are too high. The difference of means, if neither side is a p-box.
  [[nodiscard]] double bias() const noexcept { return d_minus - d_plus; }
};

/// Smallest area between any two distributions of the boxes (Ferson's choice: where the boxes overlap, nothing
/// counts). With quantiles L, R of the left and right edges:
///
///   d+ = int_0^1 max(0, L_real(p) - R_sim(p)) dp        d- = int_0^1 max(0, L_sim(p) - R_real(p)) dp
///
/// Exact for any sample sizes, weights and ties: no grid. Linear in the number of steps.
/// Source: Ferson et al. 2008, doi:10.1016/j.cma.2007.07.030; portions: Voyles & Roy 2015.
[[nodiscard]] AreaPortions areaPortions(const Comparison& boxes);

/// The same after `shift` was taken away from every simulated value. [unit of the measurand]
[[nodiscard]] AreaPortions areaPortionsAfterShift(const Comparison& boxes, double shift);

/// Area validation metric d+ + d-: the 1-Wasserstein distance of two EDFs. No metric in the sense of mathematics if a
/// side is a p-box: a box that covers the measurement has distance 0.
[[nodiscard]] double areaValidationMetric(const Comparison& boxes);

}  // namespace metrics
