#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace desktop {

/// A block of cells, row by row; rows may differ in length.
using CellBlock = std::vector<std::vector<std::string>>;

/// As spreadsheets put blocks on the clipboard: tab between cells, LF after rows, quotes around cells that hold tabs,
/// quotes or line breaks. Unlike CSV files (core/csv.h), empty lines count: they are rows with one empty cell.
[[nodiscard]] std::string toTsv(const CellBlock& block);

/// LF or CRLF; a line break at the end begins no further row. A quote inside an unquoted cell is an ordinary character.
[[nodiscard]] CellBlock fromTsv(std::string_view text);

}  // namespace desktop
