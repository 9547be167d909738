#pragma once

#include <cstddef>
#include <string>

namespace metrics {

/// Rows, columns and how many numbers were given for them, row by row.
struct GridShape {
  std::size_t rows;
  std::size_t columns;
  std::size_t numbers;
};

/// Throws InputError unless both shapes are the same, have cells, and have one number a cell. `what` names the kind:
/// "grid", "range image".
void requireSameShape(const GridShape& simulated, const GridShape& measured, const std::string& what);

/// "measured grid, row 2, column 7" for the number at `index`; counted from 1.
[[nodiscard]] std::string cellName(const std::string& grid, std::size_t index, std::size_t columns);

}  // namespace metrics
