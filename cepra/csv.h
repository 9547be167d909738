#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cepra/check.h"
#include "cepra/table.h"

namespace cepra {

/// The table as a spreadsheet shows it: UTF-8 with byte order mark (so that spreadsheets see the umlauts), one row a
/// row, header in row 1.
///
///   A key  B phenomenon  C effect_path  D effect  E design_parameters  F system_independent_causes
///   G occurrence  H occurrence_rationale  I occurrence_expert  J impact  K impact_rationale  L impact_expert
///   M relevance  N suspect  O notes  P effect_ids  Q cause_ids
///
/// G ... L, N and O may be edited; the others are there to be read. A text that a spreadsheet would take for a formula
/// (it begins with = + - @) gets an apostrophe in front, which the import removes.
void exportCsv(const Table& table, const std::filesystem::path& file);
[[nodiscard]] std::string toCsv(const Table& table);

struct CsvImport {
  Table table;                    ///< a copy of the given one with the scores of the file
  std::size_t changed = 0;        ///< rows that differ from before
  std::vector<Finding> findings;  ///< columns that were ignored, rows that the file lacks, what check() says of it
};

/// Takes scores, rationales, experts, suspect and notes from the file; rows are found by key, columns by name, so both
/// may be reordered, and rows or columns left out keep what the table has. Comma, semicolon or tab separated, LF or
/// CRLF. All or nothing: throws InputError that names the cell ("row 7, column occurrence (cell G7)") for a score that
/// is no whole number from 1 to 10, an unknown, doubled or missing key, or text that is not UTF-8.
[[nodiscard]] CsvImport importCsv(const Table& table, const std::filesystem::path& file);

}  // namespace cepra
