#pragma once

#include <vector>

#include "metrics/grids/cell_mask.h"

namespace metrics {

/// For every cell, row by row, the Manhattan distance to the nearest set cell. [cells]
///
///   . . . .      2 1 2 3
///   . # . .  ->  1 0 1 2       one pass down and right, one up and left: exact, linear in the cells
///
/// rows + columns everywhere if no cell is set: more than any distance within the grid.
/// Source: Rosenfeld & Pfaltz 1968, doi:10.1016/0031-3203(68)90013-7.
[[nodiscard]] std::vector<std::size_t> distancesToNearest(const CellMask& mask);

}  // namespace metrics
