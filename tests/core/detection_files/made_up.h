#pragma once

#include <string>

#include "core/detections.h"

namespace core_test {

/// Detections of 3 frames with every column, values that no decimal hits exactly, and two echoes of one beam.
[[nodiscard]] core::Detections madeUpDetections();

/// Expects every column to be the same, bit for bit.
void expectSame(const core::Detections& a, const core::Detections& b);

/// The three points of tests/data/detection_files: (3, 4, 0), (0, -2, 0), (1, 2, 2), coordinates in single precision.
void expectThePoints(const core::Detections& detections);

/// What the format of this name ("pcd") says of damaged content; "" if it can be read. Without a disk: thousands are
/// tried.
[[nodiscard]] std::string errorOfBytes(const std::string& format, const std::string& content);

}  // namespace core_test
