#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace app {

/// Rows of a CSV file that are told apart by what stands in some columns, with numbers in others.
struct KeyedRows {
  std::string file;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> keys;  ///< column by column; numbers in one spelling: 010 and 10.0 are 10
  std::vector<std::vector<double>> numbers;    ///< column by column
  std::vector<int> lines;                      ///< line of each row in the file, for messages

  [[nodiscard]] std::size_t size() const noexcept { return lines.size(); }
};

/// Throws InputError with file and line for a column that is missing (with the nearest), a cell that is empty or no
/// finite number, and a file without rows.
[[nodiscard]] KeyedRows readKeyedRows(const std::string& file, std::span<const std::string> keys,
                                      std::span<const std::string> numbers);

/// The rows of one key.
struct RowGroup {
  std::string name;
  std::vector<std::size_t> rows;
};

/// In order of first appearance.
[[nodiscard]] std::vector<RowGroup> groupedBy(const KeyedRows& rows, std::size_t key);

/// Rows of one name in both files; none on the side that does not have it.
struct GroupPair {
  std::string name;
  std::vector<std::size_t> real;
  std::vector<std::size_t> simulated;
};

/// Groups of both files by their first key: those of REAL in order, then those that only SIM has.
[[nodiscard]] std::vector<GroupPair> pairedGroups(const KeyedRows& real, const KeyedRows& simulated);

/// Numbers of one column in these rows.
[[nodiscard]] std::vector<double> numbersOf(const KeyedRows& rows, std::size_t column,
                                            std::span<const std::size_t> chosen);

/// Throws InputError if one is named twice.
void mustBeDistinctColumns(std::span<const std::string> columns);

}  // namespace app
