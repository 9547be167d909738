#include "model/scene/traffic.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <string_view>

#include "core/error.h"
#include "core/file.h"
#include "core/physics.h"
#include "ground_truth.pb.h"

namespace model {

namespace {

namespace osi = fidelis::ground_truth;

Vector3 vectorOf(const osi::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

template <typename Base>
Pose poseOf(const Base& base) {
  const auto& angles = base.orientation();
  return {vectorOf(base.position()), angles.yaw() * core::kDegPerRad, angles.pitch() * core::kDegPerRad,
          angles.roll() * core::kDegPerRad};
}

/// osi3::MovingObject::Type and osi3::MovingObject::VehicleClassification::Type.
TrafficKind kindOf(const osi::MovingObject& object) {
  constexpr int kVehicle = 2, kPedestrian = 3;
  if (object.type() == kPedestrian) return TrafficKind::kPedestrian;
  if (object.type() != kVehicle) return TrafficKind::kOther;
  switch (object.vehicle_classification().type()) {
    case 6:   // delivery van
    case 12:  // bus
    case 13:  // tram
    case 14:  // train
      return TrafficKind::kVan;
    case 7:  // heavy truck
      return TrafficKind::kTruck;
    case 8:  // semitrailer
    case 9:  // trailer
      return TrafficKind::kTrailer;
    case 10:  // motorbike
    case 11:  // bicycle
      return TrafficKind::kTwoWheeler;
    case 15:  // wheelchair
      return TrafficKind::kOther;
    default:  // the sizes of cars, or a type that nobody gave
      return TrafficKind::kCar;
  }
}

/// osi3::StationaryObject::Classification::Type.
TrafficKind kindOf(const osi::StationaryObject& object) {
  switch (object.classification().type()) {
    case 4:   // pole
    case 5:   // pylon
    case 6:   // delineator
    case 12:  // vertical structure
    case 15:  // reflective structure
      return TrafficKind::kPole;
    case 7:
      return TrafficKind::kTree;
    case 9:
      return TrafficKind::kVegetation;
    case 2:   // bridge
    case 3:   // building
    case 8:   // barrier
    case 10:  // kerb
    case 11:  // wall
    case 13:  // rectangular structure
    case 14:  // overhead structure
      return TrafficKind::kBuilding;
    default:
      return TrafficKind::kOther;
  }
}

template <typename Object>
TrafficObject objectOf(const Object& object, const std::string& prefix) {
  TrafficObject result;
  result.id = prefix + std::to_string(object.id().value());
  result.kind = kindOf(object);
  const auto& size = object.base().dimension();
  result.size_m = {size.length(), size.width(), size.height()};
  result.pose = poseOf(object.base());
  return result;
}

TrafficObject movingObject(const osi::MovingObject& object) {
  TrafficObject result = objectOf(object, "moving-");
  result.velocity_m_s = vectorOf(object.base().velocity());
  result.yaw_rate_rad_s = object.base().orientation_rate().yaw();
  const auto& attributes = object.vehicle_attributes();
  if (attributes.radius_wheel() > 0.0) result.wheel_radius_m = attributes.radius_wheel();
  if (attributes.ground_clearance() > 0.0) result.ground_clearance_m = attributes.ground_clearance();
  if (attributes.has_bbcenter_to_rear()) result.rear_axle_m = vectorOf(attributes.bbcenter_to_rear());
  if (attributes.has_bbcenter_to_front()) result.front_axle_m = vectorOf(attributes.bbcenter_to_front());
  return result;
}

void check(const TrafficObject& object, const core::Place& place) {
  const auto finite = [](const Vector3& v) {
    return std::all_of(v.begin(), v.end(), [](double x) { return std::isfinite(x); });
  };
  const Vector3 angles{object.pose.yaw_deg, object.pose.pitch_deg, object.pose.roll_deg};
  if (!finite(object.pose.position_m) || !finite(angles) || !finite(object.velocity_m_s)) {
    throw core::InputError(place, "object '" + object.id + "' has a pose or velocity that is not a finite number.",
                           "Correct the program that wrote the trace.");
  }
  const bool sized = std::all_of(object.size_m.begin(), object.size_m.end(), [](double x) { return x > 0.0; });
  if (!sized || !finite(object.size_m)) {
    throw core::InputError(place,
                           fmt::format("object '{}' has a bounding box of {} m × {} m × {} m.", object.id,
                                       object.size_m[0], object.size_m[1], object.size_m[2]),
                           "A box needs three positive lengths; the trace must state base.dimension.");
  }
}

/// `host` may be null: then the truth itself may name it.
TrafficFrame frameOf(const osi::GroundTruth& truth, const osi::Identifier* host, const core::Place& place) {
  TrafficFrame frame;
  frame.time_s = static_cast<double>(truth.timestamp().seconds()) + 1e-9 * truth.timestamp().nanos();
  if (host == nullptr && truth.has_host_vehicle_id()) host = &truth.host_vehicle_id();
  for (const auto& object : truth.moving_object()) {
    if (host != nullptr && object.id().value() == host->value()) frame.host = frame.objects.size();
    frame.objects.push_back(movingObject(object));
  }
  for (const auto& object : truth.stationary_object()) frame.objects.push_back(objectOf(object, "stationary-"));
  for (const TrafficObject& object : frame.objects) check(object, place);
  return frame;
}

/// One message; it may be a view with the truth inside, or the truth itself.
TrafficFrame frameOf(std::string_view message, const core::Place& place) {
  osi::SensorView view;
  const int length = static_cast<int>(message.size());
  if (view.ParseFromArray(message.data(), length) && view.has_global_ground_truth()) {
    const auto& truth = view.global_ground_truth();
    if (truth.moving_object_size() + truth.stationary_object_size() > 0 || view.has_host_vehicle_id()) {
      TrafficFrame frame = frameOf(truth, view.has_host_vehicle_id() ? &view.host_vehicle_id() : nullptr, place);
      if (view.has_mounting_position()) frame.mounting = poseOf(view.mounting_position());
      return frame;
    }
  }
  osi::GroundTruth truth;
  if (truth.ParseFromArray(message.data(), length) && truth.moving_object_size() + truth.stationary_object_size() > 0) {
    return frameOf(truth, nullptr, place);
  }
  throw core::InputError(place, "is no osi3::SensorView with a ground truth, and no osi3::GroundTruth with objects.",
                         "Give a trace of one of the two (their names often hold '_sv_' or '_gt_').");
}

}  // namespace

std::string toString(TrafficKind kind) {
  switch (kind) {
    case TrafficKind::kCar:
      return "car";
    case TrafficKind::kVan:
      return "van";
    case TrafficKind::kTruck:
      return "truck";
    case TrafficKind::kTrailer:
      return "trailer";
    case TrafficKind::kTwoWheeler:
      return "two-wheeler";
    case TrafficKind::kPedestrian:
      return "pedestrian";
    case TrafficKind::kPole:
      return "pole";
    case TrafficKind::kTree:
      return "tree";
    case TrafficKind::kVegetation:
      return "vegetation";
    case TrafficKind::kBuilding:
      return "building";
    case TrafficKind::kOther:
      return "other";
  }
  return "";
}

std::vector<TrafficFrame> readTraffic(const std::filesystem::path& file) {
  const std::string content = core::readFile(file);
  std::vector<TrafficFrame> frames;
  std::size_t at = 0;
  while (at < content.size()) {
    const core::Place place{.file = file, .item = "message " + std::to_string(frames.size())};
    std::uint32_t length = 0;
    if (content.size() - at >= sizeof length) std::memcpy(&length, content.data() + at, sizeof length);
    at += sizeof length;
    if (at > content.size() || length > content.size() - at) {
      throw core::InputError(
          place, "is cut off, or the file is no OSI trace.",
          "Give a .osi file: for each message its length as little-endian uint32, then the message.");
    }
    frames.push_back(frameOf(std::string_view(content).substr(at, length), place));
    at += length;
  }
  if (frames.empty()) throw core::InputError({.file = file}, "holds no message.", "Give an OSI trace.");
  return frames;
}

}  // namespace model
