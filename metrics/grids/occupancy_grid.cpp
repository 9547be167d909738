#include "metrics/grids/occupancy_grid.h"

#include <cmath>
#include <string>

#include "core/error.h"
#include "core/text.h"
#include "metrics/grids/grid_shape.h"

namespace metrics {

namespace {

GridShape shapeOf(const OccupancyGrid& grid) {
  return {.rows = grid.rows, .columns = grid.columns, .numbers = grid.probabilities.size()};
}

void requireProbabilities(const OccupancyGrid& grid, const std::string& name) {
  for (std::size_t i = 0; i < grid.probabilities.size(); ++i) {
    const double p = grid.probabilities[i];
    if (p >= 0.0 && p <= 1.0) continue;  // false for NaN
    throw core::InputError({.item = cellName(name, i, grid.columns)},
                           "has the occupancy probability " + core::shortestNumber(p) + "; it must lie in [0, 1].",
                           "Write 0.5 for unknown cells, and turn log odds l into 1 / (1 + exp(-l)).");
  }
}

void requireLimits(const CellLimits& limits) {
  if (limits.free_below >= 0.0 && limits.free_below <= limits.occupied_above && limits.occupied_above <= 1.0) return;
  throw core::InputError(
      {.item = "limits of free and occupied cells"},
      "are " + core::shortestNumber(limits.free_below) + " and " + core::shortestNumber(limits.occupied_above) + ".",
      "Give probabilities in [0, 1] with free_below <= occupied_above.");
}

}  // namespace

void requireComparable(const GridPair& grids) {
  requireSameShape(shapeOf(grids.simulated), shapeOf(grids.measured), "grid");
  requireProbabilities(grids.simulated, "simulated grid");
  requireProbabilities(grids.measured, "measured grid");
  const double size_m = grids.measured.cell_size_m;
  if (std::isfinite(size_m) && size_m > 0.0 && grids.simulated.cell_size_m == size_m) return;
  throw core::InputError({.item = "simulated and measured grid"},
                         "have cells of " + core::shortestNumber(grids.simulated.cell_size_m) + " m and " +
                             core::shortestNumber(size_m) + " m.",
                         "Resample both to the same cell size, greater than 0.");
}

SeriesPair cellByCell(const GridPair& grids) {
  requireComparable(grids);
  return {.simulated = grids.simulated.probabilities, .measured = grids.measured.probabilities};
}

CellMask occupiedCells(const OccupancyGrid& grid, const CellLimits& limits) {
  requireLimits(limits);
  return maskWhere(grid.rows, grid.columns, grid.probabilities, [&](double p) { return p > limits.occupied_above; });
}

CellMask freeCells(const OccupancyGrid& grid, const CellLimits& limits) {
  requireLimits(limits);
  return maskWhere(grid.rows, grid.columns, grid.probabilities, [&](double p) { return p < limits.free_below; });
}

}  // namespace metrics
