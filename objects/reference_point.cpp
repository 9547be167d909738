#include "objects/reference_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace objects {

namespace {

/// Which way a point lies from the centre, in half lengths and half widths.
struct Direction {
  ReferencePoint point;
  const char* name;
  double ahead;
  double left;
};

constexpr Direction kDirections[] = {{ReferencePoint::kCentre, "centre", 0, 0},
                                     {ReferencePoint::kFront, "front", 1, 0},
                                     {ReferencePoint::kRear, "rear", -1, 0},
                                     {ReferencePoint::kLeft, "left", 0, 1},
                                     {ReferencePoint::kRight, "right", 0, -1},
                                     {ReferencePoint::kFrontLeft, "front-left", 1, 1},
                                     {ReferencePoint::kFrontRight, "front-right", 1, -1},
                                     {ReferencePoint::kRearLeft, "rear-left", -1, 1},
                                     {ReferencePoint::kRearRight, "rear-right", -1, -1},
                                     {ReferencePoint::kRearAxle, "rear-axle", -1, 0}};  // ahead: see offsetOf

const Direction& directionOf(ReferencePoint point) { return kDirections[static_cast<std::size_t>(point)]; }

bool isSide(const Direction& d) { return d.point != ReferencePoint::kRearAxle && (d.ahead == 0) != (d.left == 0); }
bool isCorner(const Direction& d) { return d.ahead != 0 && d.left != 0; }

Vector3 offsetOf(ReferencePoint point, double length_m, double width_m, const ReferenceOptions& options) {
  const Direction& direction = directionOf(point);
  const double ahead = point == ReferencePoint::kRearAxle ? 2.0 * options.rear_axle_share - 1.0 : direction.ahead;
  return {ahead * length_m / 2, direction.left * width_m / 2, 0.0};
}

template <typename Wanted>
ReferencePoint nearest(const Box& box, Wanted wanted) {
  ReferencePoint best = ReferencePoint::kCentre;
  double least = std::numeric_limits<double>::infinity();
  for (const Direction& candidate : kDirections) {
    if (!wanted(candidate)) continue;
    const Vector3 at = stateAt(box, candidate.point).position_m;
    const double distance = std::hypot(at[0], at[1]);
    if (distance < least) {
      least = distance;
      best = candidate.point;
    }
  }
  return best;
}

/// The point of `estimate` that lies, seen from its centre, where `point` lies seen from the reference's.
ReferencePoint counterpart(const Box& estimate, const Box& reference, ReferencePoint point) {
  const Direction& direction = directionOf(point);
  if (!isSide(direction) && !isCorner(direction)) return point;
  const double turn = reference.yaw_rad - estimate.yaw_rad;
  const double ahead = std::cos(turn) * direction.ahead - std::sin(turn) * direction.left;
  const double left = std::sin(turn) * direction.ahead + std::cos(turn) * direction.left;
  ReferencePoint best = point;
  double alike = ahead * direction.ahead + left * direction.left;
  for (const Direction& candidate : kDirections) {
    if (isSide(candidate) != isSide(direction) || isCorner(candidate) != isCorner(direction)) continue;
    const double product = ahead * candidate.ahead + left * candidate.left;
    if (product > alike + 1e-12) {
      alike = product;
      best = candidate.point;
    }
  }
  return best;
}

}  // namespace

std::string toString(ReferencePoint point) { return directionOf(point).name; }

ObjectState stateAt(const Box& box, ReferencePoint point, const ReferenceOptions& options) {
  return {.point = point,
          .position_m = box.toWorld(offsetOf(point, box.length_m, box.width_m, options)),
          .length_m = box.length_m,
          .width_m = box.width_m,
          .height_m = box.height_m,
          .yaw_rad = box.yaw_rad};
}

Box boxOf(const ObjectState& state, const ReferenceOptions& options) {
  Box box{.centre_m = state.position_m,
          .length_m = state.length_m,
          .width_m = state.width_m,
          .height_m = state.height_m,
          .yaw_rad = state.yaw_rad};
  const Vector3 offset = offsetOf(state.point, state.length_m, state.width_m, options);
  box.centre_m = box.toWorld({-offset[0], -offset[1], -offset[2]});
  return box;
}

ObjectState converted(const ObjectState& state, ReferencePoint point, const ReferenceOptions& options) {
  return stateAt(boxOf(state, options), point, options);
}

ReferencePoint nearestCorner(const Box& box) { return nearest(box, isCorner); }
ReferencePoint nearestSide(const Box& box) { return nearest(box, isSide); }

const std::vector<std::string>& ReferenceChoice::names() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> list;
    for (const Direction& direction : kDirections) list.emplace_back(direction.name);
    list.emplace_back("nearest-corner");
    list.emplace_back("nearest-side");
    return list;
  }();
  return all;
}

std::optional<ReferenceChoice> ReferenceChoice::named(const std::string& name) {
  if (std::find(names().begin(), names().end(), name) == names().end()) return std::nullopt;
  return ReferenceChoice(name);
}

ReferencePoint ReferenceChoice::on(const Box& box) const {
  if (name_ == "nearest-corner") return nearestCorner(box);
  if (name_ == "nearest-side") return nearestSide(box);
  const auto found = std::find_if(std::begin(kDirections), std::end(kDirections),
                                  [this](const Direction& direction) { return name_ == direction.name; });
  return found->point;
}

Vector3 positionError(const Box& estimate, const Box& reference, const ReferenceChoice& choice,
                      const ReferenceOptions& options) {
  const ReferencePoint point = choice.on(reference);
  const Vector3 is = stateAt(estimate, counterpart(estimate, reference, point), options).position_m;
  const Vector3 should = stateAt(reference, point, options).position_m;
  return {is[0] - should[0], is[1] - should[1], is[2] - should[2]};
}

double yawError(const Box& estimate, const Box& reference) {
  const double turn = std::remainder(estimate.yaw_rad - reference.yaw_rad, std::numbers::pi);
  return turn <= -std::numbers::pi / 2 ? std::numbers::pi / 2 : turn;
}

}  // namespace objects
