#pragma once

#include "metrics/objects/object_list.h"

namespace metrics {

/// A rectangle on the ground, seen from above.
struct OrientedBox {
  double x_m = 0.0;  ///< centre
  double y_m = 0.0;
  Footprint footprint;

  [[nodiscard]] double area_m2() const noexcept { return footprint.length_m * footprint.width_m; }
};

/// Area that two boxes share: one is clipped at the sides of the other, in the other's frame. Exact but for rounding.
///
///        +-------+
///        |   +---|---+
///        |   |///|   |
///        +---|---+   |
///            +-------+
///
/// [m^2]
[[nodiscard]] double sharedArea(const OrientedBox& a, const OrientedBox& b) noexcept;

/// Jaccard distance, 1 - intersection over union: 0 for equal boxes, 1 for boxes that share nothing; 0 if both have no
/// area. A metric on boxes with area. [1]
/// Source: Jaccard 1912, doi:10.1111/j.1469-8137.1912.tb05611.x; triangle inequality: Kosub 2019,
/// doi:10.1016/j.patrec.2018.12.007.
[[nodiscard]] double jaccardDistance(const OrientedBox& a, const OrientedBox& b) noexcept;

/// Jaccard distance of two lists: mean over the larger list of the distances of objects paired so that the sum is
/// least; an object without partner counts 1. This is OSPA with the distance above, p = 1 and c = 1, hence a metric;
/// the extension to lists is ours. Two empty lists: 0. [1] Throws InputError if a number is invalid or an object has no
/// footprint.
[[nodiscard]] double jaccardDistance(const ObjectLists& lists);

}  // namespace metrics
