#pragma once

#include <span>
#include <vector>

#include "objects/box.h"

namespace objects {

/// What a good rectangle is, seen from above. D1, D2: distances of a point to the nearer of the two sides across and
/// along; the score is summed over points, and the direction with the largest wins.
///
///   area       - area of the enclosing rectangle
///   closeness  sum of 1 / max(min(D1, D2), d0): many points close to a side
///   variance   - variance of D1 where D1 < D2, - variance of D2 elsewhere: sides are straight
enum class FitCriterion { kArea, kCloseness, kVariance };

struct BoxFit {
  FitCriterion criterion = FitCriterion::kCloseness;
  double step_rad = 0.0174533;  ///< of the first search, 1°; a second one around the best is 20 times as fine
  double closest_m = 0.01;      ///< d0
};

/// The upright box that encloses the points and whose direction suits them best: two visible sides make an L, one
/// visible side a box without width. The longer side is the length, the heading lies in (-90°, 90°]; the height is that
/// of the points. Sides touch the outermost points, so noise of range makes it larger by some standard deviations,
/// measured and simulated alike. `of` must not be empty. Source: Zhang, Xu, Dong & Dolan 2017,
/// doi:10.1109/IVS.2017.7995698 (search-based rectangle fitting, Alg. 2-5). The finer second search and the middle of a
/// range of equally good directions are ours.
[[nodiscard]] Box fitBox(std::span<const Vector3> points, std::span<const std::size_t> of, const BoxFit& options = {});

}  // namespace objects
