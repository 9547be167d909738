#pragma once

#include "metrics/area/area_metric.h"
#include "metrics/distributions/comparison.h"

namespace metrics {

/// Both parts in the unit of the measurand.
struct DoubleValidation {
  double bias;      ///< d_bias; > 0: simulated values are too high
  double scatter;   ///< d_CAVM >= 0: area that remains once the bias is removed
  double residual;  ///< d_bias that the shift has left over; 0 unless a side is a p-box with width
};

/// How the bias is found that is taken away before the scatter is measured.
enum class Shift {
  One,      ///< once, by d_minus - d_plus, as published
  Balanced  ///< by the shift after which d_plus and d_minus are equal
};

/// Double validation metric (d_bias, d_CAVM): how far off, and how differently scattered.
///
///   d_bias = d- - d+        d_CAVM = AVM of the simulation moved by -d_bias
///
/// The sign is that of the published tables and figures; eq. 9-3, taken literally, would move the other way and double
/// the bias.
///
/// One shift removes the bias of an EDF exactly. Of a p-box with width it may leave a rest: quantiles that the box
/// comes to cover on the way stop counting. The rest has the sign of the bias, is never larger than it, and is reported
/// as `residual`. Balanced, the shift is the root nearest to 0 of
///
///   g(b) = int_0^1 max(0, L_sim - R_real - b) - max(0, b - (R_sim - L_real)) dp
///
/// which falls piecewise linearly; it is found exactly, by halving the set of break points. Only the balanced scatter
/// is independent of an offset added to the simulation.
///
/// Scatter can exceed the AVM (outliers: the mean shift is not the one of least area), by at most a factor of 2.
/// Source: Rosenberger 2023, doi:10.26083/tuprints-00023034, ch. 9.
[[nodiscard]] DoubleValidation doubleValidationMetric(const Comparison& boxes, Shift shift = Shift::One);

/// The root of g above. [unit of the measurand]
[[nodiscard]] double balancedShift(const Comparison& boxes);

}  // namespace metrics
