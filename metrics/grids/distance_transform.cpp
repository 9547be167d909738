#include "metrics/grids/distance_transform.h"

#include <algorithm>

namespace metrics {

std::vector<std::size_t> distancesToNearest(const CellMask& mask) {
  const std::size_t columns = mask.columns;
  std::vector<std::size_t> distances(mask.set.size(), mask.rows + columns);
  const auto closer = [&](std::size_t cell, std::size_t neighbour) {
    distances[cell] = std::min(distances[cell], distances[neighbour] + 1);
  };
  for (std::size_t cell = 0; cell < distances.size(); ++cell) {
    if (mask.set[cell] != 0) distances[cell] = 0;
    if (cell >= columns) closer(cell, cell - columns);
    if (cell % columns > 0) closer(cell, cell - 1);
  }
  for (std::size_t cell = distances.size(); cell-- > 0;) {
    if (cell + columns < distances.size()) closer(cell, cell + columns);
    if (cell % columns + 1 < columns) closer(cell, cell + 1);
  }
  return distances;
}

}  // namespace metrics
