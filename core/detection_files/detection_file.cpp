#include "core/detection_files/detection_file.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "core/detection_files/detection_format.h"
#include "core/file.h"
#include "core/text.h"

namespace core {

namespace {

/// ".pcd" of "a/B.PCD.gz".
std::string endingOf(const std::filesystem::path& file) {
  const std::filesystem::path name = file.extension() == ".gz" ? file.stem() : file.filename();
  return lowerCase(name.extension().string());
}

/// The format that the name ends in; nullptr if there is none.
const DetectionFormat* formatOfName(const std::filesystem::path& file) {
  const std::string ending = endingOf(file);
  for (const DetectionFormat& format : detectionFormats()) {
    if (std::count(format.endings.begin(), format.endings.end(), ending) > 0) return &format;
  }
  return nullptr;
}

/// What people have and we cannot read is named, so that nobody searches for a damaged header.
void refuseLas(const std::filesystem::path& file, std::string_view content) {
  if (!content.starts_with("LASF")) return;
  throw InputError({.file = file}, "is a LAS or LAZ file, which is not read.",
                   "Convert it to PLY or PCD, for example with PDAL or CloudCompare.");
}

const DetectionFormat& formatOf(const std::filesystem::path& file, std::string_view content) {
  refuseLas(file, content);
  const DetectionFormat* named = formatOfName(file);
  if (named && named->recognises(content)) return *named;
  for (const DetectionFormat& format : detectionFormats()) {
    if (format.recognises(content)) return format;
  }
  return named ? *named : detectionFormats().front();  // its reader says what is wrong
}

void checkEncoding(const std::filesystem::path& file, const DetectionFormat& format, const std::string& encoding) {
  const auto& known = format.encodings;
  if (encoding.empty() || std::count(known.begin(), known.end(), encoding) > 0) return;
  throw InputError({.file = file}, fmt::format("'{}' is no encoding of a {}.", encoding, format.title),
                   known.empty() ? "Leave it out: there is only one." : "Known are " + join(known) + ".");
}

}  // namespace

const std::vector<DetectionFormat>& detectionFormats() {
  static const std::vector<DetectionFormat> formats{csvFormat(), pcdFormat(), plyFormat(), osiFormat()};
  return formats;
}

Detections readDetections(const std::filesystem::path& file, const ColumnNames& columns) {
  const std::string content = readFile(file);
  return formatOf(file, content).read({.file = file, .content = content, .columns = columns});
}

void writeDetections(const std::filesystem::path& file, const Detections& detections, const std::string& encoding) {
  const DetectionFormat* named = formatOfName(file);
  const DetectionFormat& format = named ? *named : detectionFormats().front();
  checkEncoding(file, format, encoding);
  try {
    writeFile(file, format.write(detections,
                                 encoding.empty() && !format.encodings.empty() ? format.encodings.front() : encoding));
  } catch (const InputError& error) {
    if (!error.place().file.empty()) throw;
    throw InputError({.file = file}, error.problem(), error.remedy());
  }
}

std::int32_t wholeNumber(const Place& place, double value) {
  if (value < 0.0 || value != std::floor(value) || value > 2e9) {
    throw InputError(place, fmt::format("{} is not a whole number from 0 on.", value), "Correct the cell.");
  }
  return static_cast<std::int32_t>(value);
}

}  // namespace core
