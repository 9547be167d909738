#include "app/cli/metric/read.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "core/csv.h"
#include "core/error.h"
#include "core/file.h"
#include "core/text.h"

namespace app {

namespace {

double cellOf(std::string_view text, const std::string& file, int line, std::size_t column) {
  const std::string word = core::trimmed(text);
  if (word.empty() || core::lowerCase(word) == "nan") return std::numeric_limits<double>::quiet_NaN();
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc() && end == word.data() + word.size() && std::isfinite(value)) return value;
  throw core::InputError({.file = file, .line = line, .item = fmt::format("column {}", column + 1)},
                         "'" + word + "' is not a finite number.",
                         "A matrix has no header line; leave a cell empty where nothing is known.");
}

}  // namespace

std::vector<std::string> headerOf(const std::string& file) {
  const std::string text = core::readFile(file);
  std::vector<std::string> header;
  core::eachCsvRecord(text.substr(0, text.find('\n')), [&](int, std::span<const std::string_view> fields) {
    for (const std::string_view field : fields) header.push_back(core::trimmed(field));
  });
  if (header.empty()) throw core::InputError({.file = file}, "is empty.", "Export the file again.");
  return header;
}

bool hasColumns(const std::vector<std::string>& header, const std::vector<std::string>& names) {
  return std::all_of(names.begin(), names.end(), [&](const std::string& name) {
    return std::find(header.begin(), header.end(), name) != header.end();
  });
}

Matrix readMatrix(const std::string& file) {
  Matrix matrix;
  core::eachCsvRecord(core::readFile(file), [&](int line, std::span<const std::string_view> fields) {
    if (matrix.rows == 0) matrix.columns = fields.size();
    if (fields.size() != matrix.columns) {
      throw core::InputError({.file = file, .line = line},
                             fmt::format("has {} cells; the first row has {}.", fields.size(), matrix.columns),
                             "Every row of a matrix has the same number of cells.");
    }
    for (std::size_t i = 0; i < fields.size(); ++i) matrix.cells.push_back(cellOf(fields[i], file, line, i));
    ++matrix.rows;
  });
  if (matrix.rows == 0) throw core::InputError({.file = file}, "is empty.", "Export the file again.");
  return matrix;
}

}  // namespace app
