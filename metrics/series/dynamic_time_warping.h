#pragma once

#include <cstddef>
#include <optional>

#include "metrics/series/series_pair.h"

namespace metrics {

/// Dynamic time warping: the least sum of |difference| that is possible if either series may wait for the other.
///
///   simulated |            . o     D(i, j) = |simulated_i - measured_j|
///          ^  |        . o .                 + min( D(i-1, j), D(i, j-1), D(i-1, j-1) )
///          i  |    . o o .
///             |  o o .             o  the path of least sum, from the first pair to the last
///             +------------ j      .  edge of the band |i - j| <= window
///               measured
///
/// Unit of the measurand. Exact; time n m (n times the band's width), memory linear. Lengths may differ.
///
/// All steps weigh 1, so the sum grows with the length of the path. Within a window of 0 it is the Manhattan distance,
/// and never more than that. No metric: 0 also for series that differ only in how long values last, and the triangle
/// inequality fails. Without a window one instant may be stretched over the whole series: give the delay that can
/// physically occur.
///
/// Throws InputError if a side is empty or not finite, or if the band does not reach from the first pair to the last
/// (window below the difference of the lengths).
/// Source: Sakoe & Chiba 1978, doi:10.1109/TASSP.1978.1163055; steps unweighted as in Berndt & Clifford 1994.
[[nodiscard]] double dynamicTimeWarping(const SeriesPair& series, std::optional<std::size_t> window = {});

}  // namespace metrics
