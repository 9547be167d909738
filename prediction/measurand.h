#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/json_object.h"

namespace prediction {

/// The quantity whose errors are predicted.
struct Measurand {
  std::string name;    ///< "epw"
  std::string column;  ///< of the measurement, "epw_m"; "" if only the name was recorded
  std::string unit;    ///< of value and error alike; "" if not recorded

  bool operator==(const Measurand&) const = default;
};

/// By its name or its column; those of a detection (range, epw, intensity …) bring column and unit along. Any other
/// word is name and column at once.
[[nodiscard]] Measurand measurandNamed(const std::string& word);

/// They may be the same: what both recorded agrees.
[[nodiscard]] bool compatible(const Measurand& a, const Measurand& b);

/// "epw (epw_m, m)".
[[nodiscard]] std::string toString(const Measurand& measurand);

/// {"name", "column", "unit"}, without what was not recorded.
[[nodiscard]] nlohmann::ordered_json toJson(const Measurand& measurand);
[[nodiscard]] Measurand readMeasurand(core::JsonObject object);

}  // namespace prediction
