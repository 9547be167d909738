#pragma once

#include "metrics/distributions/edf.h"
#include "metrics/distributions/interval.h"
#include "metrics/distributions/p_box.h"

namespace metrics {

/// Half width of the Dvoretzky-Kiefer-Wolfowitz band, in probability:
///
///   eps = sqrt(ln(2 / alpha) / (2 n)),    P(sup_x |F_n(x) - F(x)| > eps) <= alpha
///
/// Holds for every n and every F, continuous or not; the constant 2 is Massart's and cannot be smaller. n need not be
/// whole (effective size). Throws InputError unless n > 0 and 0 < alpha < 1.
/// Source: Dvoretzky, Kiefer & Wolfowitz 1956, doi:10.1214/aoms/1177728174; Massart 1990, doi:10.1214/aop/1176990746.
[[nodiscard]] double confidenceHalfWidth(double n, double alpha);

/// Box that contains the distribution a sample was drawn from, the whole of it at once, with probability >= 1 - alpha.
///
///   p 1 |   _____====|         F_n + eps and F_n - eps, cut to [0, 1]
///       | _|   __|   |
///   eps |=|___|      |         below the sample F_n + eps is eps, not 0: the lower tail is unknown.
///     0 |_____|______|         Both tails end where the measurand does, at `support`.
///      low            high
///
/// From a sample alone the tails would be infinitely long and so would be the area of the box. What values are possible
/// at all must come from physics: a range counter has a smallest and a largest value. Each tail adds eps times its
/// length to the area of the box: a generous support costs little confidence, but area.
///
/// It holds for independent values. Detections that share an error (one scan, one target) are fewer than they look.
/// For weighted samples n is Kish's effective size: then the band is an approximation.
/// Throws InputError if `edf` has no sample size, alpha is not in (0, 1), or a value lies outside the support.
[[nodiscard]] PBox confidenceBand(const Edf& edf, double alpha, const Interval& support);

}  // namespace metrics
