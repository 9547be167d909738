#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "core/detections.h"

namespace core {

/// One ray of a lidar's environment model that came back: osi3::LidarSensorView::Reflection.
struct LidarReflection {
  std::size_t ray = 0;              ///< index into the view's directions
  double signal_strength_db = 0.0;  ///< 10 log10 of received over emitted power
  double time_of_flight_s = 0.0;    ///< out and back, > 0
  std::optional<double> doppler_shift_hz;
  std::optional<std::array<double, 3>> surface_normal;  ///< unit vector, in the sensor's frame
  std::optional<std::uint64_t> object;
};

/// All that one moment's rays met.
struct LidarSensorView {
  double time_s = 0.0;
  std::optional<double> emitter_frequency_hz;
  std::vector<std::array<double, 3>> directions;  ///< of every ray: unit vectors in the sensor's frame (x forward, y
                                                  ///< left, z up)
  std::vector<LidarReflection> reflections;       ///< of those that met something, in their order
};

/// Reads a trace of osi3::SensorView, one view a message. The directions of rays come from the view's configuration,
/// which may stand in the first message only; a ray without a hit has no reflection.
/// Throws InputError with message and ray: no lidar inside, no version 3, no direction for a ray, no finite number, a
/// time of flight below zero.
[[nodiscard]] std::vector<LidarSensorView> readLidarSensorViews(const std::filesystem::path& file);

/// Writes such a trace, so that a reflection-based lidar model elsewhere can be fed. All or nothing. Throws InputError
/// for more rays than a message can hold (2 GB).
void writeLidarSensorViews(const std::filesystem::path& file, std::span<const LidarSensorView> views);

/// Each reflection as a point, to look at them: frame, range c·t/2, direction. No echo pulse width, no intensity: a
/// reflection of a ray is not yet a detection.
[[nodiscard]] Detections pointsOf(std::span<const LidarSensorView> views);

}  // namespace core
