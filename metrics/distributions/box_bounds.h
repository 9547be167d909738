#pragma once

#include "metrics/distributions/interval.h"
#include "metrics/distributions/p_box.h"

namespace metrics {

/// What a p-box says about the distribution inside it. Each interval is the tightest: both ends are reached by some
/// distribution in the box. Of a single distribution it has width 0.
///
///   p 1 |       _______
///       |    __|...|       p: read across, the value that is exceeded with probability 1 - p
///     p |...|======|       x: read upwards, the probability of values <= x
///     0 |___|______|
///        ---L------R--- x
///
/// Source: Ferson et al. 2003, SAND2002-4015.

/// [L(p), R(p)], left-continuous quantiles of the edges. [unit of x] Throws InputError unless 0 <= p <= 1.
[[nodiscard]] Interval quantileInterval(const PBox& box, double p);

/// Share of values <= x: between the heights of the right and of the left edge, in [0, 1]. Throws InputError if x is
/// NaN.
[[nodiscard]] Interval probabilityInterval(const PBox& box, double x);

/// Between the means of the edges. [unit of x] Its width is the area of the box.
[[nodiscard]] Interval meanInterval(const PBox& box);

/// Every distribution inside `inner` is inside `outer`. Exact: no tolerance, edges may touch.
[[nodiscard]] bool contains(const PBox& outer, const PBox& inner);

}  // namespace metrics
