#include "core/detection_files/point_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "core/detection_files/detection_format.h"
#include "core/text.h"

namespace core {

namespace {

/// Other names under which files keep our columns.
struct Alias {
  const char* name;
  const char* other;
};
constexpr Alias kAliases[] = {
    {"layer", "ring"}, {"echo", "return_number"}, {"x", "x_m"}, {"y", "y_m"}, {"z", "z_m"},
};

std::vector<std::string> knownNames() {
  std::vector<std::string> names{"x", "y", "z"};
  for (const DetectionColumn& column : detectionColumns()) names.emplace_back(column.name);
  return names;
}

/// A field's name without what programs put around it.
std::string plain(std::string field) {
  field = lowerCase(field);
  constexpr std::string_view kPrefix = "scalar_";
  return field.starts_with(kPrefix) ? field.substr(kPrefix.size()) : field;
}

std::optional<std::size_t> fieldFor(const std::string& name, const std::vector<std::string>& fields) {
  const auto find = [&](std::string_view wanted) -> std::optional<std::size_t> {
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (plain(fields[i]) == wanted) return i;
    }
    return std::nullopt;
  };
  if (const auto own = find(name)) return own;
  for (const Alias& alias : kAliases) {
    if (name != alias.name) continue;
    if (const auto other = find(alias.other)) return other;
  }
  return std::nullopt;
}

std::size_t mappedField(const std::filesystem::path& file, const std::string& name,
                        const std::vector<std::string>& fields) {
  const auto found = std::find(fields.begin(), fields.end(), name);
  if (found != fields.end()) return static_cast<std::size_t>(found - fields.begin());
  const std::string nearest = nearestName(name, fields);
  throw InputError({.file = file}, "has no field '" + name + "'.",
                   nearest.empty() ? "Its fields are " + join(fields) + "." : "Did you mean '" + nearest + "'?");
}

/// What the file tells about where a point lies.
struct Directions {
  bool cartesian = false;  // x, y, z
  bool angles = false;     // azimuth_rad, elevation_rad
};

/// Refuses what could only be guessed.
void checkPlace(const std::filesystem::path& file, const std::vector<WantedField>& wanted,
                const std::vector<std::string>& fields) {
  const auto has = [&](const char* name) {
    return std::any_of(wanted.begin(), wanted.end(), [&](const WantedField& field) { return field.name == name; });
  };
  const std::string seen = "Its fields are " + join(fields) + ".";
  const bool cartesian = has("x") && has("y") && has("z");
  for (const char* axis : {"x", "y", "z"}) {
    if (has(axis)) continue;
    if (has("x") || has("y") || has("z") || !has("range_m")) {
      throw InputError({.file = file}, fmt::format("has no field '{}'.", axis),
                       seen + " Give x, y and z, or range_m with azimuth_rad and elevation_rad.");
    }
  }
  const int parts = int{has("azimuth_rad")} + int{has("elevation_rad")};
  if (!cartesian && (parts == 1 || (parts == 0 && has("layer")))) {
    throw InputError({.file = file}, "has only some of the fields layer, azimuth_rad and elevation_rad.", seen);
  }
}

/// The columns of a table by name.
class Columns {
 public:
  explicit Columns(const PointTable& table) : table_(table) {}
  [[nodiscard]] const std::vector<double>* find(std::string_view name) const {
    for (const PointTable::Column& column : table_.columns) {
      if (column.name == name) return &column.values;
    }
    return nullptr;
  }

 private:
  const PointTable& table_;
};

/// x, y, z of a point, if the file has them.
struct Cartesian {
  const std::vector<double>* x;
  const std::vector<double>* y;
  const std::vector<double>* z;

  explicit Cartesian(const Columns& columns) : x(columns.find("x")), y(columns.find("y")), z(columns.find("z")) {}
  [[nodiscard]] bool present() const { return x && y && z; }
  [[nodiscard]] bool isNoReturn(std::size_t i) const {
    const std::array<double, 3> p{(*x)[i], (*y)[i], (*z)[i]};
    return std::all_of(p.begin(), p.end(), [](double value) { return std::isnan(value); }) ||
           std::all_of(p.begin(), p.end(), [](double value) { return value == 0.0; });
  }
};

std::vector<std::size_t> returnsOf(const PointTable& table, const Cartesian& at) {
  std::vector<std::size_t> points;
  points.reserve(table.size());
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (!at.present() || !at.isNoReturn(i)) points.push_back(i);
  }
  return points;
}

void checkFinite(const PointTable& table, const std::vector<std::size_t>& points,
                 const std::function<Place(std::size_t)>& place_of) {
  for (const PointTable::Column& column : table.columns) {
    for (const std::size_t i : points) {
      if (std::isfinite(column.values[i])) continue;
      Place place = place_of(i);
      place.item += (place.item.empty() ? "field '" : ", field '") + column.name + "'";
      throw InputError(place, fmt::format("is {}, which is no finite number.", column.values[i]),
                       "Correct or remove the point; a beam without return has NaN in x, y and z.");
    }
  }
}

void copyColumn(const PointTable::Column& from, const DetectionColumn& to, const std::vector<std::size_t>& points,
                const std::function<Place(std::size_t)>& place_of, Detections& detections) {
  if (to.real) (detections.*to.real).reserve(points.size());
  if (to.whole) (detections.*to.whole).reserve(points.size());
  for (const std::size_t i : points) {
    if (to.real) {
      (detections.*to.real).push_back(from.values[i]);
      continue;
    }
    const double value = from.values[i];
    if (value < 0.0 || value != std::floor(value)) {  // the place is costly: only where it is needed
      Place place = place_of(i);
      place.item += (place.item.empty() ? "field '" : ", field '") + from.name + "'";
      (void)wholeNumber(place, value);
    }
    (detections.*to.whole).push_back(wholeNumber({}, value));
  }
}

/// Range and angles from x, y, z where the file does not give them.
void addSpherical(const Cartesian& at, const std::vector<std::size_t>& points, Detections& detections) {
  const bool range = detections.range_m.empty();
  const bool azimuth = detections.azimuth_rad.empty();
  const bool elevation = detections.elevation_rad.empty();
  for (const std::size_t i : points) {
    const double x = (*at.x)[i], y = (*at.y)[i], z = (*at.z)[i];
    if (range) detections.range_m.push_back(std::sqrt(x * x + y * y + z * z));
    if (azimuth) detections.azimuth_rad.push_back(std::atan2(y, x));
    if (elevation) detections.elevation_rad.push_back(std::atan2(z, std::hypot(x, y)));
  }
}

PointTable::Column cartesianColumn(const Detections& d, const std::string& name) {
  PointTable::Column column{name, NumberType::kF32, {}};
  column.values.reserve(d.size());
  for (std::size_t i = 0; i < d.size(); ++i) {
    const double across = d.range_m[i] * std::cos(d.elevation_rad[i]);
    column.values.push_back(name == "x"   ? across * std::cos(d.azimuth_rad[i])
                            : name == "y" ? across * std::sin(d.azimuth_rad[i])
                                          : d.range_m[i] * std::sin(d.elevation_rad[i]));
  }
  return column;
}

}  // namespace

std::vector<WantedField> wantedFields(const std::filesystem::path& file, const ColumnNames& columns,
                                      const std::vector<std::string>& fields) {
  std::vector<WantedField> wanted;
  for (const std::string& name : knownNames()) {
    const auto mapped = columns.find(name);
    if (mapped != columns.end()) {
      wanted.push_back({mappedField(file, mapped->second, fields), name});
    } else if (const auto index = fieldFor(name, fields)) {
      wanted.push_back({*index, name});
    }
  }
  checkPlace(file, wanted, fields);
  return wanted;
}

Detections detectionsOf(const PointTable& table, const std::function<Place(std::size_t)>& place_of) {
  const Columns columns(table);
  const Cartesian at(columns);
  const std::vector<std::size_t> points = returnsOf(table, at);
  checkFinite(table, points, place_of);
  Detections detections;
  for (const DetectionColumn& to : detectionColumns()) {
    for (const PointTable::Column& from : table.columns) {
      if (from.name == to.name) copyColumn(from, to, points, place_of, detections);
    }
  }
  if (at.present()) addSpherical(at, points, detections);
  if (!columns.find("frame")) detections.frame.assign(points.size(), 0);
  if (!columns.find("echo")) detections.echo.assign(points.size(), 1);
  return detections;
}

PointTable tableOf(const Detections& detections) {
  PointTable table;
  if (!detections.azimuth_rad.empty() || detections.size() == 0) {
    for (const char* axis : {"x", "y", "z"}) table.columns.push_back(cartesianColumn(detections, axis));
  }
  for (const DetectionColumn& column : detectionColumns()) {
    if (column.real && (detections.*column.real).size() == detections.size()) {
      table.columns.push_back({column.name, NumberType::kF64, detections.*column.real});
    } else if (column.whole && (detections.*column.whole).size() == detections.size()) {
      const std::vector<std::int32_t>& values = detections.*column.whole;
      table.columns.push_back({column.name, NumberType::kI32, {values.begin(), values.end()}});
    }
  }
  return table;
}

}  // namespace core
