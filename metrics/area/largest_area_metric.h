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
/// cost = max(0, L_real - q, q - R_real).
///
/// Why a search over edge values is exact: between two common levels the cost is constant in p and convex in q, so the
/// whole is a convex function on the polytope of rising q and is largest at a vertex; at a vertex every stretch of
/// equal q touches an edge, so each q is one of the edges' values. (A step of q inside a level can be moved to one of
/// its ends: the sum is linear in where it lies.) With best(k, v) = largest sum over the first k levels whose last q is
/// <= v,
///
///   best(k, v) = max over edge values u <= v in [L_k, R_k] of best(k-1, u) + width_k cost_k(u)
///
/// takes time levels x (edge values inside the box). If the larger cost of each level alone gives a rising q, that is
/// the answer, in linear time (a box that is clear of the measurement, or a simulation wider than it).
///
/// If the search would take more than `limit` steps, all values are first rounded to the finest grid that keeps to it.
/// Moving the edges by at most h/2 moves every choice by at most h/2, and the measurement by as much: the error is
/// at most the step h of the grid, and reported.
/// Source: Rosenberger 2022, ch. 8 (d_AVM,max); the published table follows the exact value, not the pointwise bound.
[[nodiscard]] LargestArea largestAreaMetric(const Comparison& boxes, std::size_t limit = 50'000'000);

}  // namespace metrics
