#include "app/cli/validity/output.h"

#include <algorithm>
#include <ostream>

#include "core/version.h"

namespace app {

namespace {

/// Letters, not bytes: a name may hold any UTF-8.
std::size_t width(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; }));
}

}  // namespace

nlohmann::ordered_json validityDocument(const Method& method) {
  return {{"format", "fidelis-validity"}, {"version", 1},           {"fidelis_version", core::kVersion},
          {"kind", method.kind},          {"method", method.title}, {"source", method.source}};
}

void writeTable(const std::vector<std::vector<std::string>>& rows, std::ostream& out) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width(row[i]));
  }
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += "  " + row[i];
      if (i + 1 < row.size()) line.append(widths[i] - width(row[i]), ' ');
    }
    out << line << "\n";
  }
}

std::string withUnit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : name + " [" + unit + "]";
}

std::string unitBehind(const std::string& unit) { return unit.empty() ? "" : " " + unit; }

}  // namespace app
