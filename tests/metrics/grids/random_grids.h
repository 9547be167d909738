#pragma once

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/random.h"
#include "metrics/grids/cell_mask.h"
#include "metrics/grids/occupancy_grid.h"

namespace metrics_test {

struct TwoGrids {
  metrics::OccupancyGrid simulated;
  metrics::OccupancyGrid measured;

  [[nodiscard]] metrics::GridPair pair() const { return {.simulated = simulated, .measured = measured}; }
  [[nodiscard]] metrics::GridPair exchanged() const { return {.simulated = measured, .measured = simulated}; }
};

/// A grid of 0.1 m cells.
inline metrics::OccupancyGrid grid(std::size_t rows, std::size_t columns, std::vector<double> probabilities) {
  return {.rows = rows, .columns = columns, .cell_size_m = 0.1, .probabilities = std::move(probabilities)};
}

/// The same with occupied and free exchanged.
inline TwoGrids inverse(TwoGrids both) {
  for (double& p : both.simulated.probabilities) p = 1.0 - p;
  for (double& p : both.measured.probabilities) p = 1.0 - p;
  return both;
}

/// Grids that a metric may meet: some cells certain, some unknown, some anything between.
class RandomGrids {
 public:
  explicit RandomGrids(std::uint64_t seed) : random_({.seed = seed, .purpose = core::purposeOf("grids_test")}) {}

  std::size_t edge() { return 1 + random_.below(9); }

  metrics::OccupancyGrid occupancy(std::size_t rows, std::size_t columns) {
    std::vector<double> probabilities(rows * columns);
    for (double& p : probabilities) {
      const double u = random_.uniform();
      p = random_.below(2) == 0 ? u : 0.5 * std::floor(3.0 * u);  // 0, 0.5 or 1
    }
    return grid(rows, columns, std::move(probabilities));
  }
  TwoGrids two() {
    const std::size_t rows = edge();
    const std::size_t columns = edge();
    TwoGrids both;
    both.simulated = occupancy(rows, columns);
    both.measured = occupancy(rows, columns);
    return both;
  }

  /// With about `share` of the cells set.
  metrics::CellMask mask(std::size_t rows, std::size_t columns, double share) {
    metrics::CellMask mask = {.rows = rows, .columns = columns, .set = {}};
    for (std::size_t i = 0; i < rows * columns; ++i) mask.set.push_back(random_.uniform() < share ? 1 : 0);
    return mask;
  }

 private:
  core::Random random_;
};

}  // namespace metrics_test
