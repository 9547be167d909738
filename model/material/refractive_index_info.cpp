#include "model/material/refractive_index_info.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <sstream>
#include <yaml-cpp/yaml.h>

#include "core/error.h"
#include "core/file.h"
#include "core/text.h"

namespace model {

namespace {

const char* const kExpected = "Take the YAML file of a page of refractiveindex.info as it is.";

/// One entry of DATA, with the place that its errors name.
struct Entry {
  YAML::Node node;
  std::filesystem::path file;
  std::string type;

  [[nodiscard]] core::Place place(int lines_below = 0) const {
    return {.file = file, .line = node.Mark().line + 1 + lines_below, .item = "DATA, " + type};
  }
  [[nodiscard]] std::string text(const char* key) const {
    if (!node[key] || !node[key].IsScalar()) {
      throw core::InputError(place(), fmt::format("has no '{}'.", key), kExpected);
    }
    return node[key].as<std::string>();
  }
};

std::vector<double> numbersIn(const std::string& text, const core::Place& place) {
  std::vector<double> numbers;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    double value = 0.0;
    if (!core::parseNumber(word, value) || !std::isfinite(value)) {
      throw core::InputError(place, "'" + word + "' is not a number.", kExpected);
    }
    numbers.push_back(value);
  }
  return numbers;
}

/// The rows of a table: wavelength and `columns` values each.
std::vector<std::vector<double>> rowsOf(const Entry& entry, std::size_t columns) {
  std::vector<std::vector<double>> rows;
  std::istringstream lines(entry.text("data"));
  int number = 1;  // the block begins one line below its key, the key one below the type
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const core::Place place = entry.place(number);
    std::vector<double> row = numbersIn(line, place);
    if (row.empty()) continue;
    if (row.size() != columns + 1) {
      throw core::InputError(place, fmt::format("has {} numbers; {} belong there.", row.size(), columns + 1),
                             kExpected);
    }
    if (row[0] <= 0.0) {
      throw core::InputError(place, "has a wavelength that is not positive.", "Wavelengths are in µm.");
    }
    rows.push_back(std::move(row));
  }
  // Some published tables have rows out of order or twice.
  std::stable_sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a[0] < b[0]; });
  rows.erase(std::unique(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a[0] == b[0]; }),
             rows.end());
  if (rows.empty()) throw core::InputError(entry.place(), "its table is empty.", kExpected);
  return rows;
}

OpticalTable column(const std::vector<std::vector<double>>& rows, std::size_t index) {
  OpticalTable table;
  for (const auto& row : rows) {
    table.wavelength_um.push_back(row[0]);
    table.value.push_back(row[index]);
  }
  return table;
}

OpticalFormula formulaOf(const Entry& entry) {
  double number = 0.0;
  const bool known = core::parseNumber(core::trimmed(entry.type.substr(7)), number) && number == std::floor(number) &&
                     number >= 1.0 && number <= Dispersion::kFormulas;
  if (!known) {
    throw core::InputError(entry.place(), "this formula is not known.",
                           fmt::format("Formulas 1 to {} of refractiveindex.info are.", Dispersion::kFormulas));
  }
  OpticalFormula formula;
  formula.dispersion.formula = static_cast<int>(number);
  formula.dispersion.coefficients = numbersIn(entry.text("coefficients"), entry.place());
  const std::size_t most = Dispersion::largestCount(formula.dispersion.formula);
  const std::size_t count = formula.dispersion.coefficients.size();
  if (count == 0 || count > most) {
    throw core::InputError(entry.place(), fmt::format("has {} coefficients; 1 to {} belong there.", count, most),
                           kExpected);
  }
  const auto range = numbersIn(entry.text("wavelength_range"), entry.place());
  if (range.size() != 2 || range[0] <= 0.0 || range[0] > range[1]) {
    throw core::InputError(entry.place(), "its wavelength_range is not two ascending wavelengths.", kExpected);
  }
  formula.from_um = range[0];
  formula.to_um = range[1];
  return formula;
}

/// The pieces of a file as they come; n must be there in the end.
struct Pieces {
  std::optional<OpticalCurve> n;
  std::optional<OpticalCurve> k;

  void take(const Entry& entry) {
    if (entry.type == "tabulated nk") {
      const auto rows = rowsOf(entry, 2);
      n = column(rows, 1);
      k = column(rows, 2);
    } else if (entry.type == "tabulated n") {
      n = column(rowsOf(entry, 1), 1);
    } else if (entry.type == "tabulated k") {
      k = column(rowsOf(entry, 1), 1);
    } else if (entry.type.rfind("formula", 0) == 0) {
      n = formulaOf(entry);
    } else {
      throw core::InputError(entry.place(), "this type is not known.",
                             "Known are tabulated nk, tabulated n, tabulated k and formula 1 to 9.");
    }
  }
};

}  // namespace

OpticalConstants readRefractiveIndexInfo(const std::filesystem::path& file) {
  const std::string content = core::readFile(file);
  try {
    const YAML::Node root = YAML::Load(content);
    const YAML::Node data = root.IsMap() ? root["DATA"] : YAML::Node();
    if (!data || !data.IsSequence()) throw core::InputError({.file = file}, "has no list 'DATA'.", kExpected);
    Pieces pieces;
    for (const YAML::Node& node : data) {
      Entry entry{node, file, ""};
      if (!node.IsMap()) throw core::InputError(entry.place(), "is no entry with a 'type'.", kExpected);
      entry.type = entry.text("type");
      pieces.take(entry);
    }
    if (!pieces.n) throw core::InputError({.file = file, .item = "DATA"}, "says nothing about n.", kExpected);
    return {file, *pieces.n, pieces.k};
  } catch (const YAML::Exception& error) {
    throw core::InputError({.file = file, .line = error.mark.line + 1}, "is no YAML: " + error.msg + ".", kExpected);
  }
}

}  // namespace model
