#pragma once

#include <cstddef>
#include <cstdint>

#include "metrics/points/point_cloud.h"

namespace metrics {

/// Most points on either side that pointWassersteinDistance takes. Its work grows with the cube of this for equal sizes
/// and faster for sizes without a common divisor (1000 against 999: some seconds).
inline constexpr std::size_t kMostPointsOfExactWasserstein = 1000;

/// Wasserstein distance of order p of two point clouds in which every point of a side has the same weight. [m]
///
///   W_p = min over plans f of ( sum_ij f_ij |a_i - b_j|^p )^(1/p),   sum_j f_ij = 1/n,   sum_i f_ij = 1/m
///
/// Exact for equal sizes (an assignment) and for unequal ones (a transport of whole units); no regularisation.
/// A metric on clouds read as distributions: repeating every point of a side changes nothing, so it does not see the
/// number of points (pointCountRatio does).
/// Throws InputError if a side has no point or more than the limit, a coordinate is not finite or p < 1.
/// Source: Villani 2009, Optimal Transport, doi:10.1007/978-3-540-71050-9, ch. 6.
[[nodiscard]] double pointWassersteinDistance(const CloudPair& clouds, double order = 1.0);

/// What a sliced distance takes: the same seed gives the same lines, hence the same number.
struct Slices {
  std::size_t lines = 128;
  std::uint64_t seed = 1;
};

/// Sliced Wasserstein distance: NOT the distance above, but one of its own that stays cheap for any number of points.
///
///   SW_p = ( mean over lines u of W_p(a.u, b.u)^p )^(1/p),   u uniform on the sphere
///
/// Lines are drawn; the standard error of SW_p^p falls with the root of their number. SW_p <= W_p for the same order,
/// whatever the lines. For a pure shift by d it is |d|/2 at p = 1 and |d|/sqrt(3) at p = 2 as lines grow many.
/// Throws InputError if a side has no point, a coordinate is not finite, p < 1 or there is no line.
/// Source: Bonneel, Rabin, Peyre & Pfister 2015, doi:10.1007/s10851-014-0506-3.
[[nodiscard]] double slicedWassersteinDistance(const CloudPair& clouds, double order = 1.0, const Slices& slices = {});

}  // namespace metrics
