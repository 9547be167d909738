#include "metrics/grids/picture_distance.h"

#include <limits>

#include "metrics/grids/distance_transform.h"

namespace metrics {

namespace {

/// d(from, to): mean distance of the set cells of `from` to the nearest one of `to`. Sums of whole numbers: exact.
double meanDistance(const CellMask& from, const CellMask& to) {
  const std::size_t count = from.count();
  if (count == 0) return 0.0;
  if (to.count() == 0) return std::numeric_limits<double>::infinity();
  const std::vector<std::size_t> distances = distancesToNearest(to);
  std::size_t sum = 0;
  for (std::size_t cell = 0; cell < distances.size(); ++cell) sum += from.set[cell] * distances[cell];
  return static_cast<double>(sum) / static_cast<double>(count);
}

}  // namespace

double colourDistance(const MaskPair& pictures) {
  return meanDistance(pictures.measured, pictures.simulated) + meanDistance(pictures.simulated, pictures.measured);
}

double occupiedPictureDistance(const GridPair& grids, const CellLimits& limits) {
  requireComparable(grids);
  const CellMask simulated = occupiedCells(grids.simulated, limits);
  const CellMask measured = occupiedCells(grids.measured, limits);
  return colourDistance({.simulated = simulated, .measured = measured});
}

double unoccupiedPictureDistance(const GridPair& grids, const CellLimits& limits) {
  requireComparable(grids);
  const CellMask simulated = freeCells(grids.simulated, limits);
  const CellMask measured = freeCells(grids.measured, limits);
  return colourDistance({.simulated = simulated, .measured = measured});
}

double pictureDistance(const GridPair& grids, const CellLimits& limits) {
  return occupiedPictureDistance(grids, limits) + unoccupiedPictureDistance(grids, limits);
}

}  // namespace metrics
