#include <cmath>
#include <fmt/compile.h>
#include <fmt/format.h>
#include <iterator>
#include <optional>

#include "core/csv.h"
#include "core/detection_files/detection_format.h"
#include "core/error.h"
#include "core/text.h"

namespace core {

namespace {

/// Where each of our columns stands in the file.
struct Layout {
  struct Entry {
    const DetectionColumn* column;
    std::string name;  // in the file
    std::size_t index;
  };
  std::vector<Entry> entries;

  [[nodiscard]] bool has(std::string_view name) const {
    for (const Entry& entry : entries) {
      if (entry.column->name == name) return true;
    }
    return false;
  }
};

Layout layoutOf(const std::filesystem::path& file, const ColumnNames& columns,
                std::span<const std::string_view> fields) {
  CsvTable header;
  header.file = file;
  for (const std::string_view field : fields) header.header.push_back(trimmed(field));
  Layout layout;
  for (const DetectionColumn& column : detectionColumns()) {
    const auto mapped = columns.find(column.name);
    if (mapped != columns.end()) {
      layout.entries.push_back({&column, mapped->second, header.column(mapped->second)});
    } else if (const auto index = header.findColumn(column.name)) {
      layout.entries.push_back({&column, column.name, *index});
    }
  }
  if (!layout.has("range_m")) (void)header.column("range_m");  // throws with the nearest name
  const int directions = layout.has("layer") + layout.has("azimuth_rad") + layout.has("elevation_rad");
  if (directions == 1 || directions == 2) {
    throw InputError({.file = file, .line = 1}, "has only some of the columns layer, azimuth_rad and elevation_rad.",
                     "Give all three (directions recorded) or none (directions not recorded).");
  }
  return layout;
}

/// Text whose first line could be a header.
bool recognises(std::string_view content) {
  const std::string_view first = content.substr(0, content.find('\n'));
  return first.find(',') != std::string_view::npos && first.find('\0') == std::string_view::npos &&
         !findInvalidUtf8(first);
}

Detections read(const DetectionSource& source) {
  const std::filesystem::path& file = source.file;
  Detections detections;
  std::optional<Layout> layout;
  eachCsvRecord(source.content, [&](int line, std::span<const std::string_view> fields) {
    if (!layout) {
      layout = layoutOf(file, source.columns, fields);
      return;
    }
    for (const Layout::Entry& entry : layout->entries) {
      double value = 0.0;
      if (entry.index >= fields.size() || !parseNumber(fields[entry.index], value) || !std::isfinite(value)) {
        throw InputError({.file = file, .line = line, .item = "column '" + entry.name + "'"},
                         entry.index >= fields.size()
                             ? std::string("the cell is missing.")
                             : fmt::format("'{}' is not a finite number.", fields[entry.index]),
                         "Correct the cell or remove the row.");
      }
      if (entry.column->whole) {
        (detections.*(entry.column->whole))
            .push_back(wholeNumber({.file = file, .line = line, .item = "column '" + entry.name + "'"}, value));
      } else {
        (detections.*(entry.column->real)).push_back(value);
      }
    }
  });
  if (!layout) {
    throw InputError({.file = file}, "is empty; a header line was expected.",
                     "A sample without detections still has the header line.");
  }
  if (!layout->has("echo")) detections.echo.assign(detections.size(), 1);
  if (!layout->has("frame")) detections.frame.assign(detections.size(), 0);
  return detections;
}

std::string write(const Detections& detections, const std::string&) {
  if (!detections.azimuth_rad.empty() && detections.layer.empty()) {
    throw InputError({}, "the detections have directions but no layer, which a measurement CSV needs.",
                     "Name the sensor whose layers they belong to.");
  }
  fmt::memory_buffer out;
  const auto append = std::back_inserter(out);
  // Of no detection nobody can tell what was recorded; without directions in the header it would count as pooled.
  const bool none = detections.size() == 0;
  const bool time = none || !detections.time_s.empty();
  const bool directions = none || !detections.azimuth_rad.empty();
  const bool epw = none || !detections.epw_m.empty();
  const bool intensity = none || !detections.intensity.empty();
  fmt::format_to(append, "frame,{}{}echo,range_m{}{}\n", time ? "time_s," : "",
                 directions ? "layer,azimuth_rad,elevation_rad," : "", epw ? ",epw_m" : "",
                 intensity ? ",intensity" : "");
  for (std::size_t i = 0; i < detections.size(); ++i) {
    fmt::format_to(append, FMT_COMPILE("{},"), detections.frame[i]);
    if (time) fmt::format_to(append, FMT_COMPILE("{:.6f},"), detections.time_s[i]);
    if (directions) {
      fmt::format_to(append, FMT_COMPILE("{},{:.6f},{:.6f},"), detections.layer[i], detections.azimuth_rad[i],
                     detections.elevation_rad[i]);
    }
    fmt::format_to(append, FMT_COMPILE("{},{:.4f}"), detections.echo[i], detections.range_m[i]);
    if (epw) fmt::format_to(append, FMT_COMPILE(",{:.4f}"), detections.epw_m[i]);
    if (intensity) fmt::format_to(append, FMT_COMPILE(",{:.8g}"), detections.intensity[i]);
    out.push_back('\n');
  }
  return {out.data(), out.size()};
}

}  // namespace

DetectionFormat csvFormat() {
  return {.name = "csv",
          .title = "measurement CSV",
          .endings = {".csv"},
          .encodings = {},
          .recognises = recognises,
          .read = read,
          .write = write};
}

}  // namespace core
