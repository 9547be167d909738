#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace core {

/// Calls `record` for every record of a CSV text (RFC 4180: comma, quotes, line breaks inside quotes; LF or CRLF; a
/// UTF-8 byte order mark is skipped), with the line on which the record begins. Empty lines are skipped.
/// The fields are valid during the call only. `delimiter`: spreadsheets of some countries write ';'.
void eachCsvRecord(std::string_view text,
                   const std::function<void(int line, std::span<const std::string_view> fields)>& record,
                   char delimiter = ',');

/// A CSV file held as text: what a spreadsheet shows.
struct CsvTable {
  std::filesystem::path file;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;  ///< each as long as the header
  std::vector<int> lines;                      ///< line of each row in the file, for messages

  /// Index of a column. Throws InputError that names the nearest column if it is missing.
  [[nodiscard]] std::size_t column(const std::string& name) const;
  [[nodiscard]] std::optional<std::size_t> findColumn(std::string_view name) const;
};

/// Throws InputError if the file cannot be read, has no header, doubled column names or a row of another length.
[[nodiscard]] CsvTable readCsvTable(const std::filesystem::path& file);

/// One record with quotes where they are needed, ending in LF.
[[nodiscard]] std::string csvRecord(std::span<const std::string> fields);

/// Numbers of the named columns, column by column. Throws InputError with line and column for a cell that is no
/// finite number.
[[nodiscard]] std::vector<std::vector<double>> readNumericColumns(const std::filesystem::path& file,
                                                                  std::span<const std::string> names);

}  // namespace core
