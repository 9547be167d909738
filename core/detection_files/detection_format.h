#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/detection_files/detection_file.h"
#include "core/error.h"

namespace core {

/// A measurement file on its way to detections.
struct DetectionSource {
  const std::filesystem::path& file;  ///< for messages
  std::string_view content;           ///< the whole file, decompressed
  const ColumnNames& columns;
};

/// One way of keeping detections in a file. A new one: a file in this room that returns it, its declaration below and
/// its line in detection_file.cpp.
struct DetectionFormat {
  std::string name;                    ///< "pcd"
  std::string title;                   ///< "PCD point cloud"
  std::vector<std::string> endings;    ///< with the dot, in lower case
  std::vector<std::string> encodings;  ///< among which a writer chooses, the default first; empty: there is one only
  bool (*recognises)(std::string_view content);
  Detections (*read)(const DetectionSource& source);
  std::string (*write)(const Detections& detections, const std::string& encoding);
};

[[nodiscard]] DetectionFormat csvFormat();
[[nodiscard]] DetectionFormat pcdFormat();
[[nodiscard]] DetectionFormat plyFormat();
[[nodiscard]] DetectionFormat osiFormat();

/// `value` if it is a whole number from 0 on; throws InputError at `place` otherwise.
[[nodiscard]] std::int32_t wholeNumber(const Place& place, double value);

}  // namespace core
