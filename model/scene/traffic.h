#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "model/scene/pose.h"

namespace model {

/// What a road user or a thing beside the road is, as far as its outline depends on it.
enum class TrafficKind {
  kCar,
  kVan,  ///< van, bus, tram, train: one body of full height
  kTruck,
  kTrailer,
  kTwoWheeler,
  kPedestrian,
  kPole,
  kTree,
  kVegetation,
  kBuilding,  ///< building, wall, bridge, barrier
  kOther
};
[[nodiscard]] std::string toString(TrafficKind kind);

/// One object of a traffic simulation's ground truth. Its own frame stands in the centre of its bounding box.
struct TrafficObject {
  std::string id;
  TrafficKind kind = TrafficKind::kOther;
  Vector3 size_m{};  ///< bounding box: length, width, height; all > 0
  Pose pose;         ///< in the world's frame
  Vector3 velocity_m_s{};
  double yaw_rate_rad_s = 0.0;
  std::optional<double> wheel_radius_m;
  std::optional<double> ground_clearance_m;
  std::optional<Vector3> rear_axle_m;   ///< from the box's centre, in the object's frame
  std::optional<Vector3> front_axle_m;  ///< likewise
};

/// What surrounded the sensor at one instant.
struct TrafficFrame {
  double time_s = 0.0;
  std::vector<TrafficObject> objects;  ///< in the order of the trace, the host vehicle among them
  std::optional<std::size_t> host;     ///< which of them carries the sensor
  std::optional<Pose> mounting;        ///< of the sensor in the host's frame: origin in the middle of its rear axle
};

/// Reads an ASAM OSI 3 trace of osi3::SensorView or osi3::GroundTruth messages (.osi: little-endian uint32 length, then
/// one serialised message, repeated; gzip allowed). Traffic signs, lights and lanes are not read. Throws InputError,
/// with file and number of the message, for a file that is no such trace, is cut off, holds no ground truth, or has an
/// object whose size or place is not a finite number or whose size is not positive.
[[nodiscard]] std::vector<TrafficFrame> readTraffic(const std::filesystem::path& file);

}  // namespace model
