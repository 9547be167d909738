#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "metrics/points/point_cloud.h"
#include "metrics/points/transport.h"

namespace metrics {

/// What an object covers on the ground: a rectangle around its position.
struct Footprint {
  double length_m = 0.0;  ///< along the heading
  double width_m = 0.0;
  double yaw_rad = 0.0;  ///< heading, positive from x to y
};

/// One entry of an object list, in a frame that both sides share.
struct Object {
  int id = 0;
  Position position;                   ///< centre
  std::optional<Footprint> footprint;  ///< absent: a point
  double existence = 1.0;              ///< probability that it is real
};

/// Two lists of one instant, in any order. Referred to, not owned. Either may be empty: that is a finding, not an
/// error.
struct ObjectLists {
  std::span<const Object> simulated;
  std::span<const Object> measured;
};

/// Throws InputError that names side and row (from 1): a number is not finite, a size is negative, a probability is not
/// one.
void mustBeValid(const ObjectLists& lists);

/// The objects that exist with at least this probability, in their order.
[[nodiscard]] std::vector<Object> existing(std::span<const Object> list, double least_probability);

/// Euclidean distances of positions; rows: measured, columns: simulated. [m]
[[nodiscard]] CostTable positionDistances(const ObjectLists& lists);

/// How far apart two objects may be and still be the same: the order p >= 1 weighs outliers, the cut-off c > 0 is what
/// an object without counterpart costs. The defaults are ours: a metric of squares, the length of a car.
struct SetOptions {
  double order = 2.0;
  double cutoff_m = 5.0;
};

/// Throws InputError if they are out of range.
void mustBeValid(const SetOptions& options);

/// Throws InputError "NAME is VALUE; it must be finite and not negative.": for penalties.
void mustBePenalty(double value, const std::string& name);

}  // namespace metrics
