#pragma once

#include <optional>
#include <string>
#include <vector>

#include "objects/box.h"

namespace objects {

/// The point of an object that its position is about. Two positions can only be compared if they are positions of the
/// same point: a lidar sees the near sides, so an error of length moves the centre by half of it and leaves the near
/// corner where it is.
///
///        rear-left    left    front-left
///            +----------+----------+
///            |                     |
///       rear +   +      + centre   + front  ---> heading
///            | rear-axle           |
///            +----------+----------+
///        rear-right   right   front-right
///
/// All lie at the height of the centre: of a box, its height is what a lidar of few layers knows least. The rear axle
/// lies on the centre line, a share of the length before the rear (ReferenceOptions): a vehicle's own datum, no
/// detection shows it. Source: the choice is a topic of Rosenberger 2022 (doi:10.26083/tuprints-00023034), sec. 3.2;
/// the points are those that object messages distinguish: osi3::DetectedMovingObject.reference_point,
/// osi3::BaseMoving.position (centre) and osi3::MovingObject.VehicleAttributes.bbcenter_to_rear; the object messages of
/// Ibeo scanners list the nine others.
enum class ReferencePoint {
  kCentre,
  kFront,
  kRear,
  kLeft,
  kRight,
  kFrontLeft,
  kFrontRight,
  kRearLeft,
  kRearRight,
  kRearAxle
};
[[nodiscard]] std::string toString(ReferencePoint point);

struct ReferenceOptions {
  double rear_axle_share = 0.2;  ///< distance from rear to rear axle over length, in [0, 1]; ours, of a usual car
};

/// What an object list says of an object whose position is that of `point`.
struct ObjectState {
  ReferencePoint point = ReferencePoint::kCentre;
  Vector3 position_m{};
  double length_m = 0.0;
  double width_m = 0.0;
  double height_m = 0.0;
  double yaw_rad = 0.0;
};

/// From boxes to states and back. Exact geometry, no uncertainty: each is the inverse of the other, and all points of a
/// box without size are one.
[[nodiscard]] ObjectState stateAt(const Box& box, ReferencePoint point, const ReferenceOptions& options = {});
[[nodiscard]] Box boxOf(const ObjectState& state, const ReferenceOptions& options = {});
[[nodiscard]] ObjectState converted(const ObjectState& state, ReferencePoint point,
                                    const ReferenceOptions& options = {});

/// The corner, or the middle of a side, that is nearest to the sensor. Ties: the first of the list above. These depend
/// on the view, so a state names the point that was chosen: only so can it be converted back.
[[nodiscard]] ReferencePoint nearestCorner(const Box& box);
[[nodiscard]] ReferencePoint nearestSide(const Box& box);

/// What somebody asks for: a point by its name, `nearest-corner` or `nearest-side`.
class ReferenceChoice {
 public:
  /// All names, for help and messages.
  [[nodiscard]] static const std::vector<std::string>& names();
  /// Absent if there is no such name.
  [[nodiscard]] static std::optional<ReferenceChoice> named(const std::string& name);

  [[nodiscard]] ReferencePoint on(const Box& box) const;
  [[nodiscard]] const std::string& name() const noexcept { return name_; }

 private:
  explicit ReferenceChoice(std::string name) : name_(std::move(name)) {}
  std::string name_;
};

/// Position of `estimate` minus that of `reference`, both at the same place: the chosen point of the reference, and the
/// point of the estimate that looks the same way. A box that is turned by 90° or 180° (the heading of a parked car
/// cannot be seen) thus has no position error by itself. World axes. [m]
[[nodiscard]] Vector3 positionError(const Box& estimate, const Box& reference, const ReferenceChoice& choice,
                                    const ReferenceOptions& options = {});

/// Smallest turn, modulo 180°, from the reference's heading to the estimate's, in (-90°, 90°]. [rad]
[[nodiscard]] double yawError(const Box& estimate, const Box& reference);

}  // namespace objects
