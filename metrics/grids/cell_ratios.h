#pragma once

#include "metrics/grids/occupancy_grid.h"

namespace metrics {

/// Number of simulated over number of measured cells of a class: 1 if they are equally many, wherever they lie.
///
///   ratio = #simulated / #measured, in [0, inf)
///
/// NaN if no measured cell is of the class: nothing is there to be reached. Throw InputError if the grids are not
/// comparable. That the ratio is of the two counts, not of the cells hit, is our reading of Rosenberger 2022, Tab. 4-3.
[[nodiscard]] double occupiedCellsRatio(const GridPair& grids, const CellLimits& limits = {});
[[nodiscard]] double freeCellsRatio(const GridPair& grids, const CellLimits& limits = {});

/// Jaccard distance of the occupied cells, in [0, 1]; 0 if no cell is occupied in either grid. A metric on sets.
///
///   distance = 1 - #(simulated and measured) / #(simulated or measured)
///
/// Throws InputError if the grids are not comparable. Source: Jaccard 1912, doi:10.1111/j.1469-8137.1912.tb05611.x.
[[nodiscard]] double jaccardDistance(const GridPair& grids, const CellLimits& limits = {});

}  // namespace metrics
