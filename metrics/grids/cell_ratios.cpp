#include "metrics/grids/cell_ratios.h"

#include <limits>

namespace metrics {

namespace {

double ratio(std::size_t simulated, std::size_t measured) {
  if (measured == 0) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(simulated) / static_cast<double>(measured);
}

}  // namespace

double occupiedCellsRatio(const GridPair& grids, const CellLimits& limits) {
  requireComparable(grids);
  return ratio(occupiedCells(grids.simulated, limits).count(), occupiedCells(grids.measured, limits).count());
}

double freeCellsRatio(const GridPair& grids, const CellLimits& limits) {
  requireComparable(grids);
  return ratio(freeCells(grids.simulated, limits).count(), freeCells(grids.measured, limits).count());
}

double jaccardDistance(const GridPair& grids, const CellLimits& limits) {
  requireComparable(grids);
  const CellMask simulated = occupiedCells(grids.simulated, limits);
  const CellMask measured = occupiedCells(grids.measured, limits);
  std::size_t either = 0;
  std::size_t one_only = 0;
  for (std::size_t i = 0; i < measured.set.size(); ++i) {
    either += simulated.set[i] | measured.set[i];
    one_only += simulated.set[i] ^ measured.set[i];
  }
  return either == 0 ? 0.0 : ratio(one_only, either);
}

}  // namespace metrics
