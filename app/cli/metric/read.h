#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace app {

/// The names in a CSV file's header line. Throws InputError if the file cannot be read or is empty.
[[nodiscard]] std::vector<std::string> headerOf(const std::string& file);
[[nodiscard]] bool hasColumns(const std::vector<std::string>& header, const std::vector<std::string>& names);

/// Numbers without a header line, row by row.
struct Matrix {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<double> cells;  ///< row by row; NaN where a cell is empty or says nan
};

/// Throws InputError with line and column for a cell that is neither a finite number nor missing, and for a row of
/// another length.
[[nodiscard]] Matrix readMatrix(const std::string& file);

}  // namespace app
