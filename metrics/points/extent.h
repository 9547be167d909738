#pragma once

#include "metrics/points/point_cloud.h"

namespace metrics {

/// Where a cloud is and how large, without looking at single points.

/// Mean of the points, each with the same weight. [m]
[[nodiscard]] Position centreOfGravity(std::span<const Position> cloud) noexcept;

/// Distance between the centres of gravity. 0 for clouds of equal centre, whatever their shape. [m]
/// Throws InputError if a side has no point or a coordinate is not finite.
[[nodiscard]] double centreOfGravityDistance(const CloudPair& clouds);

/// Simulated minus measured axis-aligned bounding box.
///
///        +----------+
///    +---|------+   |     size    of the box along each axis; > 0: simulated too large
///    |   |  c'  |   |     centre  of the box along each axis; > 0: simulated too far along the axis
///    |   | c    |   |     face    how far the worst of the six faces is off, max |d_centre -+ d_size / 2|
///    |   +------|---+             over the axes; 0 exactly for equal boxes
///    +----------+
///
/// The extreme points alone decide it. Choice of parts and of the scalar: ours; a metric on boxes (largest difference
/// of six coordinates).
struct BoundingBoxError {
  Position size;    ///< [m]
  Position centre;  ///< [m]
  double face;      ///< >= 0 [m]
};

/// Throws InputError if a side has no point or a coordinate is not finite.
[[nodiscard]] BoundingBoxError boundingBoxError(const CloudPair& clouds);

/// Number of simulated over number of measured points. 1: equally many; NaN if nothing was measured. [1]
[[nodiscard]] double pointCountRatio(const CloudPair& clouds) noexcept;

}  // namespace metrics
