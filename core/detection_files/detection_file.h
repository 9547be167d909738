#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/detections.h"

namespace core {

struct DetectionFormat;

/// Our column names -> the file's ("range_m" -> "Distance").
using ColumnNames = std::map<std::string, std::string>;

/// Every format that detections can be kept in (detection_format.h).
[[nodiscard]] const std::vector<DetectionFormat>& detectionFormats();

/// Reads a measurement: CSV (formats.md section 1), PCD, PLY or an ASAM OSI 3 trace of SensorData, each also gzipped.
/// The content tells the format; the ending of the name decides only where the content says nothing. `columns` maps
/// names of columns or fields; those of OSI are fixed. Unknown further columns are ignored.
/// Throws InputError with line, byte or message number: what is cut off, no finite number, or missing.
[[nodiscard]] Detections readDetections(const std::filesystem::path& file, const ColumnNames& columns = {});

/// Writes in the format that the ending names; CSV if it names none. gzip if the name ends in ".gz". CSV keeps lengths
/// to 0.1 mm and angles to a microradian, the others all digits. `encoding` is one of the format's ("" for the first).
/// Throws InputError if the format cannot hold the detections or does not know the encoding.
void writeDetections(const std::filesystem::path& file, const Detections& detections, const std::string& encoding = "");

}  // namespace core
