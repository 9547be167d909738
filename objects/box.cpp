#include "objects/box.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace objects {

Vector3 Box::toLocal(const Vector3& world) const {
  const double c = std::cos(yaw_rad), s = std::sin(yaw_rad);
  const double dx = world[0] - centre_m[0], dy = world[1] - centre_m[1];
  return {c * dx + s * dy, -s * dx + c * dy, world[2] - centre_m[2]};
}

Vector3 Box::toWorld(const Vector3& local) const {
  const double c = std::cos(yaw_rad), s = std::sin(yaw_rad);
  return {centre_m[0] + c * local[0] - s * local[1], centre_m[1] + s * local[0] + c * local[1], centre_m[2] + local[2]};
}

double wrapped(double angle_rad) {
  const double turned = std::remainder(angle_rad, 2.0 * std::numbers::pi);
  return turned <= -std::numbers::pi ? std::numbers::pi : turned;
}

Box withLongerSideAhead(const Box& box) {
  Box turned = box;
  if (turned.width_m > turned.length_m) {
    std::swap(turned.width_m, turned.length_m);
    turned.yaw_rad += std::numbers::pi / 2;
  }
  turned.yaw_rad = std::remainder(turned.yaw_rad, std::numbers::pi);
  if (turned.yaw_rad <= -std::numbers::pi / 2) turned.yaw_rad = std::numbers::pi / 2;
  return turned;
}

Box atLeast(const Box& box, const Vector3& size_m) {
  const Vector3 sensor = box.toLocal({0.0, 0.0, 0.0});
  Box grown = box;
  Vector3 shift{};
  const auto grow = [&](double& size, std::size_t axis) {
    const double missing = size_m[axis] - size;
    if (missing <= 0.0) return;
    if (axis < 2 && std::abs(sensor[axis]) > size / 2) shift[axis] = std::copysign(missing / 2, -sensor[axis]);
    size = size_m[axis];
  };
  grow(grown.length_m, 0);
  grow(grown.width_m, 1);
  grow(grown.height_m, 2);
  grown.centre_m = box.toWorld(shift);
  return grown;
}

double groundDistance(const Box& a, const Box& b) {
  return std::hypot(a.centre_m[0] - b.centre_m[0], a.centre_m[1] - b.centre_m[1]);
}

}  // namespace objects
