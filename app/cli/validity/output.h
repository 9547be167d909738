#pragma once

#include <iosfwd>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// What a result of `fidelis validity` rests on; named in every output.
struct Method {
  std::string_view kind;  ///< the sub-command
  std::string_view title;
  std::string_view source;
};

/// "fidelis-validity" as formats.md names it, up to what the kinds share.
[[nodiscard]] nlohmann::ordered_json validityDocument(const Method& method);

/// Cells below each other, two spaces apart and indented by two; the first row is the heading.
void writeTable(const std::vector<std::vector<std::string>>& rows, std::ostream& out);

/// "range_m [m]", or the name alone without a unit.
[[nodiscard]] std::string withUnit(const std::string& name, const std::string& unit);

/// " m", or "" without a unit: to be put behind a number.
[[nodiscard]] std::string unitBehind(const std::string& unit);

}  // namespace app
