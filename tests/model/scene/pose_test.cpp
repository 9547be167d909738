#include "model/scene/pose.h"

#include <cmath>
#include <gtest/gtest.h>

namespace model {
namespace {

void expectNear(const Vector3& a, const Vector3& b) {
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], 1e-12);
}

// ISO 8855: yaw turns left, a positive pitch turns the nose down, a positive roll lowers the right side.
TEST(Pose, AnglesTurnAsIso8855Says) {
  expectNear(Pose{{1, 2, 3}, 90, 0, 0}.toWorld({1, 0, 0}), {1, 3, 3});
  expectNear(Pose{{0, 0, 0}, 0, 90, 0}.toWorld({1, 0, 0}), {0, 0, -1});
  expectNear(Pose{{0, 0, 0}, 0, 0, 90}.toWorld({0, 1, 0}), {0, 0, 1});
}

// p = position + Rz(yaw) · Ry(pitch) · Rx(roll) · p_local: roll comes first, yaw last.
TEST(Pose, RollComesFirstAndYawLast) {
  expectNear(Pose{{0, 0, 0}, 90, 0, 90}.toWorld({0, 1, 0}), {0, 0, 1});
  expectNear(Pose{{0, 0, 0}, 90, 90, 0}.toWorld({1, 0, 0}), {0, 0, -1});
  expectNear(Pose{{0, 0, 0}, 90, 90, 0}.toWorld({0, 0, 1}), {0, 1, 0});
}

TEST(Pose, LocalUndoesWorldAndLengthsStay) {
  const Pose pose{{3, -4, 5}, 31, -47, 118};
  const Vector3 local{0.3, -1.7, 2.2};
  expectNear(pose.toLocal(pose.toWorld(local)), local);
  const Vector3 world = pose.toWorld(local);
  EXPECT_NEAR(std::hypot(world[0] - 3, world[1] + 4, world[2] - 5), std::hypot(0.3, 1.7, 2.2), 1e-12);
}

}  // namespace
}  // namespace model
