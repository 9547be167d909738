#include "prediction/measurand.h"

#include <array>

#include "core/text.h"

namespace prediction {

namespace {

/// What a measurement CSV holds (docs/formats.md).
const std::array<Measurand, 5> kOfDetections{{{"range", "range_m", "m"},
                                              {"epw", "epw_m", "m"},
                                              {"intensity", "intensity", "nW"},
                                              {"azimuth", "azimuth_rad", "rad"},
                                              {"elevation", "elevation_rad", "rad"}}};

}  // namespace

Measurand measurandNamed(const std::string& word) {
  for (const Measurand& known : kOfDetections) {
    if (word == known.name || word == known.column) return known;
  }
  return {.name = word, .column = word, .unit = ""};
}

bool compatible(const Measurand& a, const Measurand& b) {
  const auto agree = [](const std::string& x, const std::string& y) { return x.empty() || y.empty() || x == y; };
  const bool same_column = !a.column.empty() && a.column == b.column;
  return (same_column || (a.name == b.name && agree(a.column, b.column))) && agree(a.unit, b.unit);
}

std::string toString(const Measurand& measurand) {
  std::vector<std::string> parts;
  if (!measurand.column.empty() && measurand.column != measurand.name) parts.push_back(measurand.column);
  if (!measurand.unit.empty()) parts.push_back(measurand.unit);
  return parts.empty() ? measurand.name : measurand.name + " (" + core::join(parts) + ")";
}

nlohmann::ordered_json toJson(const Measurand& measurand) {
  nlohmann::ordered_json object{{"name", measurand.name}};
  if (!measurand.column.empty()) object["column"] = measurand.column;
  if (!measurand.unit.empty()) object["unit"] = measurand.unit;
  return object;
}

Measurand readMeasurand(core::JsonObject object) {
  Measurand measurand{
      .name = object.text("name"), .column = object.textOr("column", ""), .unit = object.textOr("unit", "")};
  object.finish();
  return measurand;
}

}  // namespace prediction
