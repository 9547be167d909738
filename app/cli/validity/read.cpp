#include "app/cli/validity/read.h"

#include <cmath>
#include <fmt/format.h>
#include <set>
#include <unordered_map>

#include "core/csv.h"
#include "core/error.h"
#include "core/file.h"
#include "core/text.h"

namespace app {

namespace {

/// Where the columns of interest stand in the records of one file.
class RecordReader {
 public:
  RecordReader(KeyedRows& rows, std::span<const std::string> keys, std::span<const std::string> numbers)
      : rows_(rows), keys_(keys), numbers_(numbers) {}

  void operator()(int line, std::span<const std::string_view> fields) {
    if (rows_.header.empty()) return readHeader(fields);
    for (std::size_t i = 0; i < keys_.size(); ++i) {
      rows_.keys[i].push_back(keyIn(cell(line, fields, key_at_[i], keys_[i]), line, keys_[i]));
    }
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
      rows_.numbers[i].push_back(numberIn(cell(line, fields, number_at_[i], numbers_[i]), line, numbers_[i]));
    }
    rows_.lines.push_back(line);
  }

 private:
  void readHeader(std::span<const std::string_view> fields) {
    core::CsvTable table;
    table.file = rows_.file;
    for (const std::string_view field : fields) table.header.push_back(core::trimmed(field));
    for (const std::string& name : keys_) key_at_.push_back(table.column(name));
    for (const std::string& name : numbers_) number_at_.push_back(table.column(name));
    rows_.header = table.header;
  }

  [[nodiscard]] core::Place place(int line, const std::string& column) const {
    return {.file = rows_.file, .line = line, .item = "column '" + column + "'"};
  }

  [[nodiscard]] std::string_view cell(int line, std::span<const std::string_view> fields, std::size_t at,
                                      const std::string& column) const {
    if (at < fields.size()) return fields[at];
    throw core::InputError(place(line, column), "the cell is missing.", "Check the commas of this row.");
  }

  [[nodiscard]] std::string keyIn(std::string_view text, int line, const std::string& column) const {
    const std::string key = core::trimmed(text);
    if (key.empty()) {
      throw core::InputError(place(line, column), "is empty.", "Name what this row belongs to, or remove the row.");
    }
    double number = 0.0;
    return core::parseNumber(key, number) && std::isfinite(number) ? core::shortestNumber(number) : key;
  }

  [[nodiscard]] double numberIn(std::string_view text, int line, const std::string& column) const {
    double number = 0.0;
    if (core::parseNumber(text, number) && std::isfinite(number)) return number;
    throw core::InputError(place(line, column), fmt::format("'{}' is not a finite number.", text),
                           "Write a number with a decimal point, or remove the row.");
  }

  KeyedRows& rows_;
  std::span<const std::string> keys_;
  std::span<const std::string> numbers_;
  std::vector<std::size_t> key_at_;
  std::vector<std::size_t> number_at_;
};

}  // namespace

KeyedRows readKeyedRows(const std::string& file, std::span<const std::string> keys,
                        std::span<const std::string> numbers) {
  KeyedRows rows{.file = file,
                 .header = {},
                 .keys = std::vector<std::vector<std::string>>(keys.size()),
                 .numbers = std::vector<std::vector<double>>(numbers.size()),
                 .lines = {}};
  core::eachCsvRecord(core::readFile(file), RecordReader(rows, keys, numbers));
  if (rows.size() > 0) return rows;
  throw core::InputError({.file = file},
                         rows.header.empty() ? "is empty; a header line was expected." : "has a header and no rows.",
                         "Check the export.");
}

std::vector<RowGroup> groupedBy(const KeyedRows& rows, std::size_t key) {
  std::vector<RowGroup> groups;
  std::unordered_map<std::string, std::size_t> known;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const auto [found, is_new] = known.try_emplace(rows.keys[key][row], groups.size());
    if (is_new) groups.push_back({.name = found->first, .rows = {}});
    groups[found->second].rows.push_back(row);
  }
  return groups;
}

std::vector<GroupPair> pairedGroups(const KeyedRows& real, const KeyedRows& simulated) {
  std::vector<GroupPair> pairs;
  std::unordered_map<std::string, std::size_t> known;
  for (RowGroup& group : groupedBy(real, 0)) {
    known.emplace(group.name, pairs.size());
    pairs.push_back({.name = group.name, .real = std::move(group.rows), .simulated = {}});
  }
  for (RowGroup& group : groupedBy(simulated, 0)) {
    const auto found = known.find(group.name);
    if (found != known.end()) {
      pairs[found->second].simulated = std::move(group.rows);
    } else {
      pairs.push_back({.name = group.name, .real = {}, .simulated = std::move(group.rows)});
    }
  }
  return pairs;
}

std::vector<double> numbersOf(const KeyedRows& rows, std::size_t column, std::span<const std::size_t> chosen) {
  std::vector<double> numbers;
  numbers.reserve(chosen.size());
  for (const std::size_t row : chosen) numbers.push_back(rows.numbers[column][row]);
  return numbers;
}

void mustBeDistinctColumns(std::span<const std::string> columns) {
  std::set<std::string> seen;
  for (const std::string& column : columns) {
    if (seen.insert(column).second) continue;
    throw core::InputError({.item = "--column " + column}, "is given twice.", "Give every column once.");
  }
}

}  // namespace app
