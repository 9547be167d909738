#include "model/scene/pose.h"

#include <cmath>

#include "core/physics.h"

namespace model {

std::array<Vector3, 3> Pose::rotation() const {
  const double cy = std::cos(yaw_deg * core::kRadPerDeg), sy = std::sin(yaw_deg * core::kRadPerDeg);
  const double cp = std::cos(pitch_deg * core::kRadPerDeg), sp = std::sin(pitch_deg * core::kRadPerDeg);
  const double cr = std::cos(roll_deg * core::kRadPerDeg), sr = std::sin(roll_deg * core::kRadPerDeg);
  return {{{cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr},
           {sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr},
           {-sp, cp * sr, cp * cr}}};
}

Vector3 Pose::toWorld(const Vector3& local) const {
  const auto r = rotation();
  Vector3 world = position_m;
  for (std::size_t i = 0; i < 3; ++i) world[i] += r[i][0] * local[0] + r[i][1] * local[1] + r[i][2] * local[2];
  return world;
}

Vector3 Pose::toLocal(const Vector3& world) const {
  const auto r = rotation();
  const Vector3 d = {world[0] - position_m[0], world[1] - position_m[1], world[2] - position_m[2]};
  Vector3 local{};
  for (std::size_t i = 0; i < 3; ++i) local[i] = r[0][i] * d[0] + r[1][i] * d[1] + r[2][i] * d[2];
  return local;
}

namespace {

using Rotation = std::array<Vector3, 3>;

/// Angles of a rotation Rz·Ry·Rx; where the nose points straight up or down, only yaw and roll together count.
Pose poseOf(const Vector3& position_m, const Rotation& r) {
  const double cos_pitch = std::hypot(r[0][0], r[1][0]);
  const bool upright = cos_pitch < 1e-12;
  return {position_m, core::kDegPerRad * (upright ? std::atan2(-r[0][1], r[1][1]) : std::atan2(r[1][0], r[0][0])),
          core::kDegPerRad * std::atan2(-r[2][0], cos_pitch),
          upright ? 0.0 : core::kDegPerRad * std::atan2(r[2][1], r[2][2])};
}

}  // namespace

Pose chained(const Pose& parent, const Pose& child) {
  const Rotation a = parent.rotation(), b = child.rotation();
  Rotation product{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) product[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
  }
  return poseOf(parent.toWorld(child.position_m), product);
}

Pose seenFrom(const Pose& frame, const Pose& pose) {
  const Rotation a = frame.rotation(), b = pose.rotation();
  Rotation product{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) product[i][j] = a[0][i] * b[0][j] + a[1][i] * b[1][j] + a[2][i] * b[2][j];
  }
  return poseOf(frame.toLocal(pose.position_m), product);
}

Vector3 turnedInto(const Pose& frame, const Vector3& vector) {
  return Pose{{}, frame.yaw_deg, frame.pitch_deg, frame.roll_deg}.toLocal(vector);
}

}  // namespace model
