#include "metrics/grids/distance_transform.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "tests/metrics/grids/random_grids.h"

namespace {

using metrics::CellMask;
using metrics::distancesToNearest;
using metrics_test::RandomGrids;

std::size_t apart(std::size_t a, std::size_t b) { return a > b ? a - b : b - a; }

/// By trying every set cell.
std::size_t nearest(const CellMask& mask, std::size_t cell) {
  std::size_t best = mask.rows + mask.columns;
  for (std::size_t other = 0; other < mask.set.size(); ++other) {
    if (mask.set[other] == 0) continue;
    best = std::min(
        best, apart(cell / mask.columns, other / mask.columns) + apart(cell % mask.columns, other % mask.columns));
  }
  return best;
}

TEST(DistanceTransform, IsTheManhattanDistanceToTheNearestSetCell) {
  RandomGrids cases(201);
  for (int k = 0; k < 200; ++k) {
    const std::size_t rows = cases.edge();
    const CellMask mask = cases.mask(rows, cases.edge(), 0.1 * (k % 10));
    const std::vector<std::size_t> distances = distancesToNearest(mask);
    ASSERT_EQ(distances.size(), mask.set.size());
    for (std::size_t cell = 0; cell < distances.size(); ++cell) EXPECT_EQ(distances[cell], nearest(mask, cell));
  }
}

TEST(DistanceTransform, OfOneCellIsADiamond) {
  const CellMask mask = {.rows = 2, .columns = 4, .set = {0, 0, 0, 0, 0, 1, 0, 0}};
  EXPECT_EQ(distancesToNearest(mask), (std::vector<std::size_t>{2, 1, 2, 3, 1, 0, 1, 2}));
}

TEST(DistanceTransform, WithoutASetCellIsBeyondTheGrid) {
  const CellMask mask = {.rows = 2, .columns = 3, .set = std::vector<std::uint8_t>(6, 0)};
  EXPECT_EQ(distancesToNearest(mask), std::vector<std::size_t>(6, 5));
}

}  // namespace
