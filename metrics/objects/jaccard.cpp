#include "metrics/objects/jaccard.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "core/error.h"
#include "metrics/objects/ospa.h"

namespace metrics {

namespace {

/// Coordinates along the two sides of the box that clips.
using Corner = std::array<double, 2>;
using Polygon = std::vector<Corner>;

/// Corners of `box` as seen from the centre of `frame`, along its sides; counter-clockwise.
Polygon cornersIn(const OrientedBox& frame, const OrientedBox& box) {
  const double turn = box.footprint.yaw_rad - frame.footprint.yaw_rad;
  const double c = std::cos(frame.footprint.yaw_rad);
  const double s = std::sin(frame.footprint.yaw_rad);
  const double dx = box.x_m - frame.x_m;
  const double dy = box.y_m - frame.y_m;
  const Corner centre{c * dx + s * dy, c * dy - s * dx};
  const double half_length = 0.5 * box.footprint.length_m;
  const double half_width = 0.5 * box.footprint.width_m;
  Polygon corners;
  for (const auto& [u, v] : {Corner{1, 1}, Corner{-1, 1}, Corner{-1, -1}, Corner{1, -1}}) {
    const double along = u * half_length;
    const double across = v * half_width;
    corners.push_back({centre[0] + std::cos(turn) * along - std::sin(turn) * across,
                       centre[1] + std::sin(turn) * along + std::cos(turn) * across});
  }
  return corners;
}

/// The part of a convex polygon with sign * corner[axis] <= limit. Source: Sutherland & Hodgman 1974,
/// doi:10.1145/360767.360802.
Polygon clipped(const Polygon& polygon, std::size_t axis, double sign, double limit) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner& from = polygon[i];
    const Corner& to = polygon[(i + 1) % polygon.size()];
    const double inside_from = limit - sign * from[axis];
    const double inside_to = limit - sign * to[axis];
    if (inside_from >= 0.0) kept.push_back(from);
    if ((inside_from > 0.0 && inside_to < 0.0) || (inside_from < 0.0 && inside_to > 0.0)) {
      const double t = inside_from / (inside_from - inside_to);
      Corner crossing{from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])};
      crossing[axis] = sign * limit;
      kept.push_back(crossing);
    }
  }
  return kept;
}

double areaOf(const Polygon& polygon) {
  double twice = 0.0;  // shoelace
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner& p = polygon[i];
    const Corner& q = polygon[(i + 1) % polygon.size()];
    twice += p[0] * q[1] - q[0] * p[1];
  }
  return std::max(0.0, 0.5 * twice);
}

OrientedBox boxOf(std::span<const Object> list, std::size_t i, const char* side) {
  if (list[i].footprint) return {list[i].position.x_m, list[i].position.y_m, *list[i].footprint};
  throw core::InputError({.item = fmt::format("{} object {}", side, i + 1)},
                         "has no size; boxes are needed to say what they share.",
                         "Give length, width and yaw, or take a metric of positions such as OSPA.");
}

std::vector<OrientedBox> boxesOf(std::span<const Object> list, const char* side) {
  std::vector<OrientedBox> boxes;
  for (std::size_t i = 0; i < list.size(); ++i) boxes.push_back(boxOf(list, i, side));
  return boxes;
}

}  // namespace

double sharedArea(const OrientedBox& a, const OrientedBox& b) noexcept {
  Polygon shared = cornersIn(a, b);
  for (const double sign : {1.0, -1.0}) {
    shared = clipped(shared, 0, sign, 0.5 * a.footprint.length_m);
    shared = clipped(shared, 1, sign, 0.5 * a.footprint.width_m);
  }
  return std::min({areaOf(shared), a.area_m2(), b.area_m2()});
}

double jaccardDistance(const OrientedBox& a, const OrientedBox& b) noexcept {
  const double shared = sharedArea(a, b);
  const double together = a.area_m2() + b.area_m2() - shared;
  return together > 0.0 ? 1.0 - shared / together : 0.0;
}

double jaccardDistance(const ObjectLists& lists) {
  mustBeValid(lists);
  const std::vector<OrientedBox> measured = boxesOf(lists.measured, "measured");
  const std::vector<OrientedBox> simulated = boxesOf(lists.simulated, "simulated");
  const CostTable distances(measured.size(), simulated.size(),
                            [&](std::size_t i, std::size_t j) { return jaccardDistance(measured[i], simulated[j]); });
  return ospa(distances, {.order = 1.0, .cutoff_m = 1.0}).distance;
}

}  // namespace metrics
