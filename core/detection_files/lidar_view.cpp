#include "core/detection_files/lidar_view.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <limits>

#include "core/detection_files/osi_trace.h"
#include "core/file.h"
#include "core/physics.h"
#include "osi3_lidar.pb.h"

namespace core {

namespace {

namespace osi3 = fidelis::osi3;

constexpr double kNanosPerSecond = 1e9;

std::array<double, 3> toArray(const osi3::Vector3d& vector) { return {vector.x(), vector.y(), vector.z()}; }

void fill(const std::array<double, 3>& from, osi3::Vector3d& to) {
  to.set_x(from[0]);
  to.set_y(from[1]);
  to.set_z(from[2]);
}

Place placeOf(const OsiTrace& trace, std::size_t message, int ray) {
  Place place = trace.placeOf(message);
  place.item += fmt::format(", ray {}", ray + 1);
  return place;
}

/// Asked for only where something is wrong: there are millions of rays.
using PlaceOfRay = std::function<Place()>;

/// The one lidar of a message; nullptr if there is none.
const osi3::LidarSensorView* lidarOf(const osi3::SensorView& view, const Place& place) {
  if (view.lidar_sensor_view_size() > 1) {
    throw InputError(place, "holds more than one lidar_sensor_view.", "Write a trace for each sensor.");
  }
  return view.lidar_sensor_view_size() == 1 ? &view.lidar_sensor_view(0) : nullptr;
}

std::array<double, 3> directionOf(const osi3::Vector3d& from, const PlaceOfRay& place) {
  std::array<double, 3> to = toArray(from);
  const double length = std::hypot(to[0], to[1], to[2]);
  if (!std::isfinite(length) || length == 0.0) {
    throw InputError(place(), "has a direction without length, or with a number that is not finite.",
                     "Write a unit vector in view_configuration.directions.");
  }
  for (double& part : to) part /= length;
  return to;
}

LidarReflection reflectionOf(const osi3::LidarSensorView::Reflection& from, int ray, const PlaceOfRay& place) {
  LidarReflection to;
  to.ray = static_cast<std::size_t>(ray);
  to.signal_strength_db = from.signal_strength();
  to.time_of_flight_s = from.time_of_flight();
  if (from.has_doppler_shift()) to.doppler_shift_hz = from.doppler_shift();
  const osi3::Vector3d& normal = from.normal_to_surface();
  if (!std::isfinite(to.signal_strength_db + to.time_of_flight_s + from.doppler_shift() + normal.x() + normal.y() +
                     normal.z())) {
    throw InputError(place(), "holds a number that is not finite.", "Leave the fields of a ray without a hit unset.");
  }
  if (to.time_of_flight_s < 0.0) {
    throw InputError(place(), fmt::format("has a time of flight of {:g} s.", to.time_of_flight_s),
                     "Write the time out and back, or leave the fields of a ray without a hit unset.");
  }
  if (from.has_normal_to_surface()) to.surface_normal = toArray(normal);
  if (from.has_object_id()) to.object = from.object_id().value();
  return to;
}

/// A ray without a hit has no time of flight, or a strength of minus infinity.
bool isHit(const osi3::LidarSensorView::Reflection& reflection) {
  return reflection.has_time_of_flight() && reflection.time_of_flight() != 0.0 &&
         reflection.signal_strength() != -std::numeric_limits<double>::infinity();
}

LidarSensorView viewOf(const OsiTrace& trace, std::size_t message, const osi3::LidarSensorView& lidar,
                       const osi3::LidarSensorViewConfiguration& configuration) {
  if (configuration.directions_size() != lidar.reflection_size()) {
    throw InputError(trace.placeOf(message),
                     fmt::format("has {} reflections and {} directions of rays in its view_configuration.",
                                 lidar.reflection_size(), configuration.directions_size()),
                     "Write one direction for every reflection.");
  }
  LidarSensorView view;
  if (configuration.has_emitter_frequency()) view.emitter_frequency_hz = configuration.emitter_frequency();
  for (int i = 0; i < lidar.reflection_size(); ++i) {
    const auto place = [&] { return placeOf(trace, message, i); };
    view.directions.push_back(directionOf(configuration.directions(i), place));
    if (isHit(lidar.reflection(i))) view.reflections.push_back(reflectionOf(lidar.reflection(i), i, place));
  }
  return view;
}

/// A message of protocol buffers holds less than 2 GB. Bytes of a direction, and of a whole reflection at most.
bool fitsIntoMessage(const LidarSensorView& view) {
  constexpr std::size_t kBytesPerRay = 31, kBytesPerReflection = 70;
  return view.directions.size() * kBytesPerRay + view.reflections.size() * kBytesPerReflection <
         static_cast<std::size_t>(std::numeric_limits<int>::max());
}

osi3::SensorView messageOf(const LidarSensorView& view) {
  constexpr std::uint64_t kSensor = 1;
  osi3::SensorView message;
  message.mutable_version()->set_version_major(kOsiMajor);
  message.mutable_version()->set_version_minor(kOsiMinor);
  message.mutable_version()->set_version_patch(0);
  const double seconds = std::floor(view.time_s);
  message.mutable_timestamp()->set_seconds(static_cast<std::int64_t>(seconds));
  message.mutable_timestamp()->set_nanos(
      static_cast<std::uint32_t>(std::min(std::round((view.time_s - seconds) * kNanosPerSecond), kNanosPerSecond - 1)));
  message.mutable_sensor_id()->set_value(kSensor);
  osi3::LidarSensorView& lidar = *message.add_lidar_sensor_view();
  osi3::LidarSensorViewConfiguration& configuration = *lidar.mutable_view_configuration();
  configuration.mutable_sensor_id()->set_value(kSensor);
  configuration.set_num_of_pixels(static_cast<std::uint32_t>(view.directions.size()));
  if (view.emitter_frequency_hz) configuration.set_emitter_frequency(*view.emitter_frequency_hz);
  for (const std::array<double, 3>& direction : view.directions) {
    fill(direction, *configuration.add_directions());
    (void)lidar.add_reflection();  // one a ray; it stays empty if nothing was met
  }
  for (const LidarReflection& from : view.reflections) {
    osi3::LidarSensorView::Reflection& to = *lidar.mutable_reflection(static_cast<int>(from.ray));
    to.set_signal_strength(from.signal_strength_db);
    to.set_time_of_flight(from.time_of_flight_s);
    if (from.doppler_shift_hz) to.set_doppler_shift(*from.doppler_shift_hz);
    if (from.surface_normal) fill(*from.surface_normal, *to.mutable_normal_to_surface());
    if (from.object) to.mutable_object_id()->set_value(*from.object);
  }
  return message;
}

}  // namespace

std::vector<LidarSensorView> readLidarSensorViews(const std::filesystem::path& file) {
  const std::string content = readFile(file);
  const OsiTrace trace = readOsiTrace(file, content);
  std::vector<LidarSensorView> views;
  osi3::LidarSensorViewConfiguration configuration;
  std::optional<std::size_t> without_version;
  bool any = false;
  for (std::size_t m = 0; m < trace.messages.size() && trace.kind == OsiKind::kSensorView; ++m) {
    osi3::SensorView message;
    if (!message.ParseFromArray(trace.messages[m].data(), static_cast<int>(trace.messages[m].size()))) {
      throw InputError(trace.placeOf(m), "is no valid SensorView.", "Copy or record the trace again.");
    }
    if (!message.has_version() && !without_version) without_version = m;
    if (message.has_version()) checkOsiVersion(trace, m, true, message.version().version_major());
    LidarSensorView& view = views.emplace_back();
    if (const osi3::LidarSensorView* lidar = lidarOf(message, trace.placeOf(m))) {
      any = true;
      if (lidar->view_configuration().directions_size() > 0) configuration = lidar->view_configuration();
      view = viewOf(trace, m, *lidar, configuration);
    }
    view.time_s = static_cast<double>(message.timestamp().seconds()) +
                  static_cast<double>(message.timestamp().nanos()) / kNanosPerSecond;
  }
  if (trace.kind == OsiKind::kSensorData) {
    throw InputError({.file = file}, "holds detections (SensorData), not reflections.", "Read it as a measurement.");
  }
  if (!any) throw noLidarIn(trace, without_version);
  if (without_version) checkOsiVersion(trace, *without_version, false, 0);
  return views;
}

void writeLidarSensorViews(const std::filesystem::path& file, std::span<const LidarSensorView> views) {
  std::string trace;
  for (const LidarSensorView& view : views) {
    if (!fitsIntoMessage(view)) {
      throw InputError({.file = file},
                       fmt::format("would need more than 2 GB for the {} rays of a message, the most that one holds.",
                                   view.directions.size()),
                       "Take fewer rays_per_beam, or fewer beams.");
    }
    appendOsiMessage(trace, messageOf(view).SerializeAsString());
  }
  writeFile(file, trace);
}

Detections pointsOf(std::span<const LidarSensorView> views) {
  Detections points;
  for (std::size_t frame = 0; frame < views.size(); ++frame) {
    for (const LidarReflection& reflection : views[frame].reflections) {
      const auto& [x, y, z] = views[frame].directions[reflection.ray];
      points.frame.push_back(static_cast<std::int32_t>(frame));
      points.echo.push_back(1);
      points.range_m.push_back(kSpeedOfLight_m_s / 2.0 * reflection.time_of_flight_s);
      points.azimuth_rad.push_back(std::atan2(y, x));
      points.elevation_rad.push_back(std::atan2(z, std::hypot(x, y)));
    }
  }
  return points;
}

}  // namespace core
