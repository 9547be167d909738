#pragma once

#include <span>
#include <vector>

#include "model/scene/pose.h"

namespace objects {

using model::Vector3;

/// Two detections belong together if they are near each other, and "near" grows with range as the beams part.
///
///   sqrt(dx² + dy² + (vertical_weight · dz)²) < distance_m + distance_per_range · r,   r: range of the farther one
///
/// On a surface seen under the angle λ, neighbouring beams Δφ apart are r sin Δφ / sin(λ − Δφ) apart: 0.026 r for
/// Δφ = 0.25° and λ = 10°. Layers are farther apart than columns, so heights count less.
/// Source: Borges & Aldon 2004, doi:10.1023/B:JINT.0000038945.55712.65 (distance that adapts to range).
struct Nearness {
  double distance_m = 0.5;
  double distance_per_range = 0.02;
  double vertical_weight = 0.25;
};

/// Euclidean clusters: sets of indices that are connected by steps between near ones. Every index is in one; sets and
/// indices in them are in rising order (a set stands at its first index), so the order of the points alone decides.
[[nodiscard]] std::vector<std::vector<std::size_t>> clustersOf(std::span<const Vector3> points,
                                                               std::span<const std::size_t> indices,
                                                               const Nearness& nearness);

}  // namespace objects
