#pragma once

#include <cstddef>
#include <vector>

#include "metrics/grids/cell_mask.h"
#include "metrics/series/series_pair.h"

namespace metrics {

/// Ground in square cells, each with the probability that something stands in it.
///
///              column 0    1    2
///       row 0        0.1  0.9  0.5      0: surely free, 0.5: unknown, 1: surely occupied
///       row 1        0.0  1.0  0.5
///
/// Frame: any, but the same for both grids of a comparison: cell (r, c) must be the same piece of ground. A grid that
/// is shifted by one cell is a wrong grid, not one to be aligned here.
struct OccupancyGrid {
  std::size_t rows = 0;
  std::size_t columns = 0;
  double cell_size_m = 0.0;           ///< edge of a cell
  std::vector<double> probabilities;  ///< in [0, 1], row by row
};

/// What is compared. Referred to, not owned.
struct GridPair {
  const OccupancyGrid& simulated;
  const OccupancyGrid& measured;
};

/// Where occupied begins and free ends. What lies between, and an unknown cell at 0.5, is neither.
struct CellLimits {
  double occupied_above = 0.5;  ///< occupied: probability > this
  double free_below = 0.5;      ///< free: probability < this; at most occupied_above
};

/// Throws InputError unless both grids have the same rows, columns and cell size (> 0) and probabilities in [0, 1]; it
/// names the cell. Every metric of grids asks this first.
void requireComparable(const GridPair& grids);

/// The probabilities as two series, cell by cell, unknown cells included at 0.5: metrics/series/ serves them.
[[nodiscard]] SeriesPair cellByCell(const GridPair& grids);

/// Throw InputError if the limits are exchanged or outside [0, 1].
[[nodiscard]] CellMask occupiedCells(const OccupancyGrid& grid, const CellLimits& limits);
[[nodiscard]] CellMask freeCells(const OccupancyGrid& grid, const CellLimits& limits);

}  // namespace metrics
