#pragma once

#include "model/scene/pose.h"

namespace objects {

using model::Vector3;

/// An upright box: what an object list says of an object's extent.
///
///          yaw
///     +-----^------+      length  along the heading
///     |      \     |      width   across it, to the left
///     |   centre   |      height  up
///     +------------+
///
/// Frame: ISO 8855, sensor at the origin. A box that was fitted to detections has its heading along the longer side,
/// between -90° (excluded) and 90°: who moves where cannot be seen in one frame.
struct Box {
  Vector3 centre_m{};
  double length_m = 0.0;
  double width_m = 0.0;
  double height_m = 0.0;
  double yaw_rad = 0.0;  ///< positive to the left

  bool operator==(const Box&) const = default;

  /// Into the box's own frame (x along the heading, origin at the centre) and back.
  [[nodiscard]] Vector3 toLocal(const Vector3& world) const;
  [[nodiscard]] Vector3 toWorld(const Vector3& local) const;
};

/// Angle wrapped into (-pi, pi].
[[nodiscard]] double wrapped(double angle_rad);

/// The same rectangle with the longer side as its length and the heading in (-90°, 90°].
[[nodiscard]] Box withLongerSideAhead(const Box& box);

/// Grown to at least these sizes (length, width, height), away from the sensor: sides that it sees stay where they
/// are. A side whose two ends are both seen (the sensor stands between them) grows to both sides. Up: to both sides.
[[nodiscard]] Box atLeast(const Box& box, const Vector3& size_m);

/// How far apart two centres are on the ground. [m]
[[nodiscard]] double groundDistance(const Box& a, const Box& b);

}  // namespace objects
