#include "core/detections.h"

#include <cmath>
#include <fmt/compile.h>
#include <fmt/format.h>
#include <iterator>
#include <optional>

#include "core/csv.h"
#include "core/error.h"
#include "core/file.h"
#include "core/text.h"

namespace core {

namespace {

struct Column {
  const char* name;
  std::vector<double> Detections::*real;
  std::vector<std::int32_t> Detections::*whole;
};

constexpr Column kColumns[] = {
    {"frame", nullptr, &Detections::frame},
    {"time_s", &Detections::time_s, nullptr},
    {"layer", nullptr, &Detections::layer},
    {"azimuth_rad", &Detections::azimuth_rad, nullptr},
    {"elevation_rad", &Detections::elevation_rad, nullptr},
    {"echo", nullptr, &Detections::echo},
    {"range_m", &Detections::range_m, nullptr},
    {"epw_m", &Detections::epw_m, nullptr},
    {"intensity", &Detections::intensity, nullptr},
};

/// Where each of our columns stands in the file.
struct Layout {
  struct Entry {
    const Column* column;
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

Layout layoutOf(const std::filesystem::path& file, const std::map<std::string, std::string>& columns,
                std::span<const std::string_view> fields) {
  CsvTable header;
  header.file = file;
  for (const std::string_view field : fields) header.header.push_back(trimmed(field));
  Layout layout;
  for (const Column& column : kColumns) {
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

std::int32_t wholeNumber(const std::filesystem::path& file, int line, const std::string& name, double value) {
  if (value < 0.0 || value != std::floor(value) || value > 2e9) {
    throw InputError({.file = file, .line = line, .item = "column '" + name + "'"},
                     fmt::format("{} is not a whole number from 0 on.", value), "Correct the cell.");
  }
  return static_cast<std::int32_t>(value);
}

}  // namespace

const std::vector<double>* Detections::values(const std::string& column) const {
  for (const Column& candidate : kColumns) {
    if (candidate.real && column == candidate.name) {
      const std::vector<double>& list = this->*candidate.real;
      return list.size() == size() ? &list : nullptr;
    }
  }
  return nullptr;
}

Detections selected(const Detections& detections, std::span<const std::size_t> indices) {
  Detections chosen;
  const auto copy = [&](const auto& from, auto& to) {
    if (from.empty()) return;  // not recorded
    to.reserve(indices.size());
    for (const std::size_t i : indices) to.push_back(from[i]);
  };
  for (const Column& column : kColumns) {
    if (column.real) copy(detections.*column.real, chosen.*column.real);
    if (column.whole) copy(detections.*column.whole, chosen.*column.whole);
  }
  return chosen;
}

Detections readDetections(const std::filesystem::path& file, const std::map<std::string, std::string>& columns) {
  Detections detections;
  std::optional<Layout> layout;
  const std::string text = readFile(file);
  eachCsvRecord(text, [&](int line, std::span<const std::string_view> fields) {
    if (!layout) {
      layout = layoutOf(file, columns, fields);
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
        (detections.*(entry.column->whole)).push_back(wholeNumber(file, line, entry.name, value));
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

void writeDetections(const std::filesystem::path& file, const Detections& detections) {
  fmt::memory_buffer out;
  const auto append = std::back_inserter(out);
  const bool time = !detections.time_s.empty();
  const bool directions = !detections.azimuth_rad.empty();
  const bool epw = !detections.epw_m.empty();
  const bool intensity = !detections.intensity.empty();
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
  writeFile(file, {out.data(), out.size()});
}

}  // namespace core
