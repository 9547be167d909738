#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/detection_files/detection_file.h"
#include "core/detection_files/number_type.h"
#include "core/error.h"

namespace core {

/// A point cloud as named columns of numbers: what PCD and PLY have in common.
///
///   x, y, z             position in the sensor's frame (ISO 8855)              [m]
///   our column names    as in a measurement CSV: frame, layer, azimuth_rad, range_m, epw_m, …
///
/// range_m, azimuth_rad and elevation_rad of the file are used where it has them, and computed from x, y, z where not.
/// Also understood: ring for layer, return_number for echo, x_m, y_m, z_m, and the prefix scalar_ (CloudCompare).
/// A point with x, y, z all NaN or all zero stands for a beam without return and is left out.
struct PointTable {
  struct Column {
    std::string name;  ///< ours: "x", "range_m", …
    NumberType type = NumberType::kF64;
    std::vector<double> values;
  };
  std::vector<Column> columns;

  [[nodiscard]] std::size_t size() const { return columns.empty() ? 0 : columns.front().values.size(); }
};

/// A field of a file that becomes a column.
struct WantedField {
  std::size_t index;  ///< among the file's fields
  std::string name;   ///< ours
};

/// Which of a file's fields are of use. Throws InputError that lists the fields if neither x, y, z nor range_m can be
/// had, or only a part of a direction.
[[nodiscard]] std::vector<WantedField> wantedFields(const std::filesystem::path& file, const ColumnNames& columns,
                                                    const std::vector<std::string>& fields);

/// Throws InputError for a value that is not finite, or not whole where it must be; `place_of` says where a point is.
[[nodiscard]] Detections detectionsOf(const PointTable& table, const std::function<Place(std::size_t)>& place_of);

/// x, y, z as single precision for viewers (absent without directions), then our columns with all their digits.
[[nodiscard]] PointTable tableOf(const Detections& detections);

}  // namespace core
