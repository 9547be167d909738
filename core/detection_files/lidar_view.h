#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "core/detections.h"

namespace core {

/// One ray of a lidar's environment model that came back: osi3::LidarSensorView::Reflection with its direction.
struct LidarReflection {
  std::array<double, 3> direction{1, 0, 0};  ///< unit vector from the sensor, in its frame (x forward, y left, z up)
  double signal_strength_db = 0.0;           ///< received power in dBm less emitted power in dBm
  double time_of_flight_s = 0.0;             ///< out and back, > 0
  double doppler_shift_hz = 0.0;
  std::optional<std::array<double, 3>> surface_normal;  ///< unit vector, in the sensor's frame
  std::optional<std::uint64_t> object;
};

/// All reflections of one moment, in the order of the rays.
struct LidarSensorView {
  double time_s = 0.0;
  std::optional<double> emitter_frequency_hz;
  std::vector<LidarReflection> reflections;
};

/// Reads a trace of osi3::SensorView, one view a message. Rays without a hit are left out. The directions of rays come
/// from the view's configuration, which may stand in the first message only.
/// Throws InputError with message and ray: no lidar inside, no version 3, no direction for a ray, no finite number.
[[nodiscard]] std::vector<LidarSensorView> readLidarSensorViews(const std::filesystem::path& file);

/// Writes such a trace, so that a reflection-based lidar model elsewhere can be fed. All or nothing.
void writeLidarSensorViews(const std::filesystem::path& file, std::span<const LidarSensorView> views);

/// Each reflection as a point, to look at them: frame, range c·t/2, direction. No echo pulse width, no intensity: a
/// reflection of a ray is not yet a detection.
[[nodiscard]] Detections pointsOf(std::span<const LidarSensorView> views);

}  // namespace core
