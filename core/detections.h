#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace core {

/// Detections of one sample, column by column, in the order of the file: what a sensor reported, one entry an echo.
/// Measured and simulated detections have the same type; nobody downstream can tell them apart.
struct Detections {
  std::vector<std::int32_t> frame;    ///< from 0
  std::vector<double> time_s;         ///< since the start of the frame; empty if not recorded
  std::vector<std::int32_t> layer;    ///< index in the profile; empty if not recorded (point clouds often lack it)
  std::vector<double> azimuth_rad;    ///< positive to the left; empty if directions were not recorded
  std::vector<double> elevation_rad;  ///< positive up; empty like azimuth_rad
  std::vector<std::int32_t> echo;     ///< from 1
  std::vector<double> range_m;
  std::vector<double> epw_m;      ///< echo pulse width c·Δt, not halved; empty if not recorded
  std::vector<double> intensity;  ///< peak power in nW; empty if not recorded

  [[nodiscard]] std::size_t size() const noexcept { return range_m.size(); }
  [[nodiscard]] bool hasDirections() const noexcept { return !azimuth_rad.empty() || size() == 0; }

  /// The values of a measurement column ("range_m", "epw_m", "intensity", "azimuth_rad", …), nullptr if not recorded.
  [[nodiscard]] const std::vector<double>* values(const std::string& column) const;
};

/// The detections of these indices, in their order, as often as they are listed.
[[nodiscard]] Detections selected(const Detections& detections, std::span<const std::size_t> indices);

/// A column of a measurement: its name and where its values are, in one of the two.
struct DetectionColumn {
  const char* name;
  std::vector<double> Detections::*real;
  std::vector<std::int32_t> Detections::*whole;
};

/// All columns, in the order in which a measurement lists them.
[[nodiscard]] std::span<const DetectionColumn> detectionColumns();

}  // namespace core
