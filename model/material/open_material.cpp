#include "model/material/open_material.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "core/json_object.h"
#include "core/text.h"

namespace model {

namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr double kRoomTemperature_K = 293.15;
constexpr double kSameAngle_rad = 2e-3;  ///< azimuths of gonioreflectometers come in steps of 1° (0.017 rad) at least

/// A row of numbers; null (allowed by the standard for what is unknown) is NaN.
std::vector<double> numbersOf(const json& row, std::size_t count, const core::Place& place) {
  std::vector<double> numbers;
  const bool fits = row.is_array() && row.size() == count &&
                    std::all_of(row.begin(), row.end(), [](const json& v) { return v.is_number() || v.is_null(); });
  if (!fits) {
    throw core::InputError(place, fmt::format("is not a row of {} numbers.", count),
                           "See the table's schema in ASAM OpenMATERIAL 3D.");
  }
  for (const json& value : row) numbers.push_back(value.is_null() ? std::nan("") : value.get<double>());
  return numbers;
}

const json& arrayAt(const json& table, const char* pointer, const fs::path& file) {
  const json::json_pointer where(pointer);
  if (!table.contains(where) || !table.at(where).is_array()) {
    throw core::InputError({.file = file, .item = pointer}, "is missing or no list.",
                           "Name a table of the right kind (*_brdf.xompt, *_optical.xompt).");
  }
  return table.at(where);
}

std::string textAt(const json& value, const char* pointer) {
  const json::json_pointer where(pointer);
  return value.contains(where) && value.at(where).is_string() ? value.at(where).get<std::string>() : "";
}

/// Exit zenith and value on the side of the light, of one wavelength and incidence.
struct Arc {
  core::Place place;
  double wavelength_m = 0.0;
  double incidence_rad = 0.0;
  std::vector<std::pair<double, double>> exits;
};

bool towardsLight(double zenith_rad, double azimuth_rad) {
  const double away = std::remainder(azimuth_rad, 2.0 * std::numbers::pi);
  return zenith_rad < 1e-9 || std::abs(away) < kSameAngle_rad;  // straight up every azimuth is the same
}

std::optional<BrdfRow> retroreflected(Arc& arc) {
  std::sort(arc.exits.begin(), arc.exits.end());
  const auto upper = std::find_if(arc.exits.begin(), arc.exits.end(), [&](const auto& exit) {
    return exit.first >= arc.incidence_rad - 1e-6;  // angles come with six decimals
  });
  if (upper == arc.exits.end()) return std::nullopt;
  BrdfRow row{arc.place, arc.wavelength_m * 1e9, arc.incidence_rad, upper->second};
  if (upper->first <= arc.incidence_rad + 1e-6) return row;
  if (upper == arc.exits.begin()) return std::nullopt;
  const auto& lower = *(upper - 1);
  const double share = (arc.incidence_rad - lower.first) / (upper->first - lower.first);
  row.value = lower.second + share * (upper->second - lower.second);
  return row;
}

std::vector<Arc> arcsOf(const json& table, const fs::path& file) {
  std::vector<Arc> arcs;
  const json& lines = arrayAt(table, "/brdf/lookupTable", file);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const core::Place place{.file = file, .item = fmt::format("/brdf/lookupTable/{}", i)};
    const auto row = numbersOf(lines[i], 5, place);
    if (std::any_of(row.begin(), row.end(), [](double v) { return std::isnan(v); })) continue;  // not measured
    if (row[0] <= 0.0) throw core::InputError(place, "has a wavelength that is not positive.", "Give it in m.");
    // The standard demands rows sorted by wavelength and incidence.
    if (arcs.empty() || arcs.back().wavelength_m != row[0] || arcs.back().incidence_rad != row[1]) {
      arcs.push_back({place, row[0], row[1], {}});
    }
    if (towardsLight(row[2], row[3])) arcs.back().exits.emplace_back(row[2], row[4]);
  }
  return arcs;
}

void appendRows(const fs::path& file, const json& table, std::vector<BrdfRow>& rows) {
  const std::size_t before = rows.size();
  for (Arc& arc : arcsOf(table, file)) {
    if (auto row = retroreflected(arc)) rows.push_back(std::move(*row));
  }
  if (rows.size() == before) {
    throw core::InputError({.file = file, .item = "/brdf/lookupTable"},
                           "has no value in the direction that the light comes from.",
                           "A lidar needs rows with exit zenith = incidence zenith and exit azimuth 0.");
  }
}

/// The BRDF tables of a material that are there: those for lidars, or all of them if none says so.
std::vector<std::pair<fs::path, json>> brdfTablesOf(const json& material, const fs::path& file) {
  std::vector<std::pair<fs::path, json>> all, for_lidar;
  for (const json& uri : arrayAt(material, "/materialProperties/brdfUris", file)) {
    const fs::path table = uri.is_string() ? file.parent_path() / uri.get<std::string>() : fs::path();
    if (!fs::is_regular_file(table)) continue;  // one for cameras need not come along
    all.emplace_back(table, core::readJson(table));
    if (core::lowerCase(textAt(all.back().second, "/metadata/typicalSensorTechnology")).find("lidar") !=
        std::string::npos) {
      for_lidar.push_back(all.back());
    }
  }
  if (all.empty()) {
    throw core::InputError({.file = file, .item = "/materialProperties/brdfUris"}, "none of the tables is there.",
                           "Copy the *_brdf.xompt file beside it.");
  }
  return for_lidar.empty() ? all : for_lidar;
}

/// A row of optical properties.
struct OpticsLine {
  double um, away_K, n, k;
};

OpticalConstants opticsIn(const json& content, const fs::path& file) {
  std::vector<OpticsLine> lines;
  const json& table = arrayAt(content, "/opticalProperties", file);
  for (std::size_t i = 0; i < table.size(); ++i) {
    const core::Place place{.file = file, .item = fmt::format("/opticalProperties/{}", i)};
    const auto row = numbersOf(table[i], 4, place);
    if (std::isnan(row[0]) || std::isnan(row[2])) continue;
    if (row[0] <= 0.0) throw core::InputError(place, "has a wavelength that is not positive.", "Give it in m.");
    const double away_K = std::isnan(row[1]) ? 0.0 : std::abs(row[1] - kRoomTemperature_K);
    lines.push_back({row[0] * 1e6, away_K, row[2], std::isnan(row[3]) ? 0.0 : row[3]});
  }
  std::stable_sort(lines.begin(), lines.end(), [](const OpticsLine& a, const OpticsLine& b) {
    return std::pair(a.um, a.away_K) < std::pair(b.um, b.away_K);
  });
  OpticalTable n, k;
  for (const OpticsLine& line : lines) {
    if (!n.wavelength_um.empty() && n.wavelength_um.back() == line.um) continue;
    n.wavelength_um.push_back(line.um);
    n.value.push_back(line.n);
    k.wavelength_um.push_back(line.um);
    k.value.push_back(line.k);
  }
  if (n.value.empty()) {
    throw core::InputError({.file = file, .item = "/opticalProperties"}, "holds no values.", "Give at least one row.");
  }
  return {file, n, k};
}

}  // namespace

bool isOpenMaterial(const fs::path& file) {
  const std::string ending = core::lowerCase(file.extension().string());
  return ending == ".xomp" || ending == ".xompt";
}

std::vector<BrdfRow> readOpenMaterialBrdf(const fs::path& file, std::vector<fs::path>& files) {
  const json content = core::readJson(file);
  files.push_back(file);
  std::vector<BrdfRow> rows;
  if (content.contains("brdf")) {
    appendRows(file, content, rows);
    return rows;
  }
  for (const auto& [table_file, table] : brdfTablesOf(content, file)) {
    files.push_back(table_file);
    appendRows(table_file, table, rows);
  }
  return rows;
}

OpticalConstants readOpenMaterialOptics(const fs::path& file, std::vector<fs::path>& files) {
  const json content = core::readJson(file);
  files.push_back(file);
  const std::string uri = textAt(content, "/materialProperties/opticalPropertiesUri");
  if (uri.empty()) return opticsIn(content, file);
  files.push_back(file.parent_path() / uri);
  return opticsIn(core::readJson(files.back()), files.back());
}

}  // namespace model
