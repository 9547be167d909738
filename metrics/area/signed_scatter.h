#pragma once

#include "metrics/area/double_validation_metric.h"
#include "metrics/distributions/comparison.h"

namespace metrics {

/// Is the simulated scatter too wide or too narrow? d_CAVM has no sign; this gives it one. With the distance D(p) of
/// the quantiles that is left once the bias b is taken away (what a box covers counts 0),
///
///   s = int_0^1 sign(p - 1/2) D(p) dp        D = max(0, L_sim - b - R_real) - max(0, L_real - (R_sim - b))
///
///   simulated values      too high   too low
///   upper half, p > 1/2      +          -         s > 0: too wide
///   lower half, p < 1/2      -          +         s < 0: too narrow      [unit of the measurand]
///
/// |s| <= d_CAVM of the same shift, for s is the same area with signs. Read them together:
///
///   |s| near d_CAVM    the two differ in width: scale the simulated noise
///   |s| << d_CAVM      they are equally wide but of another shape (tails, two modes, skew): scaling will not help
///
/// Of two samples it is E|Y - median(Y)| - E|X - median(X)|, whatever the shift; of N(., s_sim) and N(., s_real) it is
/// (s_sim - s_real) sqrt(2 / pi). Of boxes with width it depends on the shift; with the balanced one it is independent
/// of an offset added to either side.
/// Source: this project. Rosenberger 2023 leaves the sign of the scatter open.
[[nodiscard]] double signedScatter(const Comparison& boxes, Shift shift = Shift::One);

/// The same after `bias` was taken away from every simulated value. [unit of the measurand]
[[nodiscard]] double signedScatterAfterShift(const Comparison& boxes, double bias);

}  // namespace metrics
