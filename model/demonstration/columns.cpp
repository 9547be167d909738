#include "model/demonstration/columns.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/physics.h"

namespace model {

namespace {

using core::Detections;

struct Column {
  const char* name;
  double (*of)(const Detections&, std::size_t);
  bool (*recorded)(const Detections&);
};

double flat(const Detections& d, std::size_t i) { return d.range_m[i] * std::cos(d.elevation_rad[i]); }
bool directions(const Detections& d) { return d.hasDirections(); }
bool intensities(const Detections& d) { return d.intensity.size() == d.size(); }

constexpr double kMicroPerNano = 1e-3;

/// The list.
constexpr Column kColumns[] = {
    {"x_m", [](const Detections& d, std::size_t i) { return flat(d, i) * std::cos(d.azimuth_rad[i]); }, directions},
    {"y_m", [](const Detections& d, std::size_t i) { return flat(d, i) * std::sin(d.azimuth_rad[i]); }, directions},
    {"z_m", [](const Detections& d, std::size_t i) { return d.range_m[i] * std::sin(d.elevation_rad[i]); }, directions},
    {"azimuth_deg", [](const Detections& d, std::size_t i) { return d.azimuth_rad[i] * core::kDegPerRad; }, directions},
    {"elevation_deg", [](const Detections& d, std::size_t i) { return d.elevation_rad[i] * core::kDegPerRad; },
     directions},
    {"range_m", [](const Detections& d, std::size_t i) { return d.range_m[i]; },
     [](const Detections&) { return true; }},
    {"epw_m", [](const Detections& d, std::size_t i) { return d.epw_m[i]; },
     [](const Detections& d) { return d.epw_m.size() == d.size(); }},
    {"layer", [](const Detections& d, std::size_t i) { return static_cast<double>(d.layer[i]); },
     [](const Detections& d) { return d.layer.size() == d.size(); }},
    {"intensity", [](const Detections& d, std::size_t i) { return d.intensity[i]; }, intensities},
    {"intensity_uw", [](const Detections& d, std::size_t i) { return kMicroPerNano * d.intensity[i]; }, intensities},
};

}  // namespace

const std::vector<std::string>& shownColumns() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const Column& column : kColumns) list.emplace_back(column.name);
    return list;
  }();
  return names;
}

std::vector<double> shownColumn(const Detections& detections, const std::string& name) {
  const auto* column =
      std::find_if(std::begin(kColumns), std::end(kColumns), [&](const Column& entry) { return name == entry.name; });
  if (column == std::end(kColumns) || !column->recorded(detections)) {
    throw core::InputError({.item = "column '" + name + "'"}, "is not known of these detections.",
                           "Name another one in 'draw', or let the scene's sensor put it out.");
  }
  std::vector<double> values(detections.size());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = column->of(detections, i);
  return values;
}

}  // namespace model
