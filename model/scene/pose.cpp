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

}  // namespace model
