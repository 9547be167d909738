#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace core {

/// Detections of one sample, column by column, in the order of the file: what a sensor reported, one entry an echo.
/// Measured and simulated detections have the same type; nobody downstream can tell them apart.
struct Detections {
  std::vector<std::int32_t> frame;    ///< from 0
  std::vector<double> time_s;         ///< since the start of the frame; empty if not recorded
  std::vector<std::int32_t> layer;    ///< index in the profile; empty if directions were not recorded
  std::vector<double> azimuth_rad;    ///< positive to the left; empty like layer
  std::vector<double> elevation_rad;  ///< positive up; empty like layer
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

/// Reads a measurement CSV (formats.md section 1). `columns` maps our names to the file's ("range_m" -> "Distance").
/// Unknown further columns are ignored. Throws InputError with line and column: a cell that is no finite number, a
/// negative frame, range_m missing.
[[nodiscard]] Detections readDetections(const std::filesystem::path& file,
                                        const std::map<std::string, std::string>& columns = {});

/// Writes it again, lengths to 0.1 mm and angles to a microradian. gzip if the name says so.
void writeDetections(const std::filesystem::path& file, const Detections& detections);

}  // namespace core
