#pragma once

#include <array>

namespace model {

using Vector3 = std::array<double, 3>;

/// p = position + Rz(yaw) · Ry(pitch) · Rx(roll) · p_local; frame ISO 8855 (x forward, y left, z up).
struct Pose {
  Vector3 position_m{};
  double yaw_deg = 0.0;
  double pitch_deg = 0.0;
  double roll_deg = 0.0;

  /// Rows of the rotation Rz·Ry·Rx.
  [[nodiscard]] std::array<Vector3, 3> rotation() const;
  [[nodiscard]] Vector3 toWorld(const Vector3& local) const;
  [[nodiscard]] Vector3 toLocal(const Vector3& world) const;
};

/// Where a child stands in the frame in which its parent stands.
[[nodiscard]] Pose chained(const Pose& parent, const Pose& child);

/// The same pose as it looks from `frame`: chained(frame, seenFrom(frame, pose)) is `pose`.
[[nodiscard]] Pose seenFrom(const Pose& frame, const Pose& pose);

/// The vector's components along the axes of `frame`.
[[nodiscard]] Vector3 turnedInto(const Pose& frame, const Vector3& vector);

}  // namespace model
