#pragma once

#include <cstddef>

#include "metrics/distributions/comparison.h"

namespace metrics {

/// In the unit of the measurand.
struct LargestArea {
  double area;   ///< d_AVM,max
  double error;  ///< the true value lies within area -+ error; 0: exact
};

/// Largest area validation metric of all distributions inside the simulated box, each against the measured box (of
/// which, as in the AVM, the nearest part counts): how bad the simulation may be, where the AVM says how good.
///
/// At every level p a quantile q(p) in [L(p), R(p)] is chosen, rising with p, to maximise int cost(p, q(p)) dp with
/// cost = max(0, L_real - q, q - R_real), which is convex in q and depends on p only through the edges.
///
/// Why a search over edge values is exact:
///   1. Within a level, where all edges are constant, let q rise from a to b. Being convex, the cost is nowhere larger
///      than at a or at b. Constantly a, or constantly b, q still rises and stays in the box, and costs no less. So one
///      value per level suffices, and finitely many numbers q_1 <= ... <= q_m remain, L_k <= q_k <= R_k.
///   2. Their sum of costs is convex on this bounded polytope, hence largest at one of its corners.
///   3. At a corner, take a run of equal q_k that differs from its neighbours. If none of them met its L_k or R_k, the
///      run could move up and down a little, and a corner can not. So its value is one of the edges' values.
///
/// With best(k, v) = largest sum over the first k levels whose last q is <= v,
///
///   best(k, v) = max over edge values u <= v in [L_k, R_k] of best(k-1, u) + width_k cost_k(u)
///
/// takes time levels x (edge values inside the box). If the larger cost of each level alone gives a rising q, that is
/// the answer, in linear time (a box that is clear of the measurement, or a simulation wider than it).
///
/// If the search would take more than `limit` steps, all values are first rounded to the finest grid that keeps to it.
/// No edge moves by more than h/2 on a grid of step h. A choice within the old edges, clipped to the new ones, still
/// rises and moves by no more than that, and vice versa; the measurement moves by h/2 as well. The error is at most h,
/// and reported.
/// Source: Rosenberger 2022, ch. 8 (d_AVM,max); the published table follows the exact value, not the pointwise bound.
[[nodiscard]] LargestArea largestAreaMetric(const Comparison& boxes, std::size_t limit = 50'000'000);

}  // namespace metrics
