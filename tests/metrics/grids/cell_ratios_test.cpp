#include "metrics/grids/cell_ratios.h"

#include <cmath>
#include <gtest/gtest.h>

#include "tests/metrics/grids/random_grids.h"

namespace {

using metrics::freeCellsRatio;
using metrics::jaccardDistance;
using metrics::OccupancyGrid;
using metrics::occupiedCells;
using metrics::occupiedCellsRatio;
using metrics_test::grid;
using metrics_test::RandomGrids;
using metrics_test::TwoGrids;

TEST(CellRatios, CountWithoutRegardToPlace) {
  const TwoGrids both = {.simulated = grid(1, 5, {0.9, 0.9, 0.9, 0.1, 0.5}),
                         .measured = grid(1, 5, {0.1, 0.1, 0.5, 0.9, 0.9})};
  EXPECT_EQ(occupiedCellsRatio(both.pair()), 1.5);
  EXPECT_EQ(freeCellsRatio(both.pair()), 0.5);
  EXPECT_DOUBLE_EQ(occupiedCellsRatio(both.exchanged()), 1.0 / 1.5);
  EXPECT_EQ(freeCellsRatio(both.exchanged()), 2.0);
}

TEST(CellRatios, WithoutAMeasuredCellAreUndefined) {
  const TwoGrids both = {.simulated = grid(1, 2, {0.9, 0.1}), .measured = grid(1, 2, {0.5, 0.5})};
  EXPECT_TRUE(std::isnan(occupiedCellsRatio(both.pair())));
  EXPECT_TRUE(std::isnan(freeCellsRatio(both.pair())));
  EXPECT_EQ(occupiedCellsRatio(both.exchanged()), 0.0);
  EXPECT_EQ(freeCellsRatio(both.exchanged()), 0.0);
}

// Occupied: cells 0, 1, 2 against 0, 2, 3.
TEST(JaccardDistance, IsOneLessIntersectionOverUnion) {
  const TwoGrids both = {.simulated = grid(1, 4, {0.9, 0.9, 0.9, 0.1}), .measured = grid(1, 4, {0.9, 0.1, 0.9, 0.9})};
  EXPECT_EQ(jaccardDistance(both.pair()), 1.0 - 2.0 / 4.0);
}

TEST(JaccardDistance, OfTwoEmptyGridsIsZeroAndOfDisjointOnesOne) {
  const OccupancyGrid empty = grid(1, 2, {0.1, 0.5});
  const OccupancyGrid left = grid(1, 2, {0.9, 0.5});
  const OccupancyGrid right = grid(1, 2, {0.1, 0.9});
  EXPECT_EQ(jaccardDistance({.simulated = empty, .measured = empty}), 0.0);
  EXPECT_EQ(jaccardDistance({.simulated = empty, .measured = left}), 1.0);
  EXPECT_EQ(jaccardDistance({.simulated = left, .measured = right}), 1.0);
}

TEST(JaccardDistance, IsAMetric) {
  RandomGrids cases(232);
  for (int k = 0; k < 200; ++k) {
    const TwoGrids ends = cases.two();
    const OccupancyGrid between = cases.occupancy(ends.measured.rows, ends.measured.columns);
    const double direct = jaccardDistance(ends.pair());
    EXPECT_EQ(direct, jaccardDistance(ends.exchanged()));
    EXPECT_EQ(direct == 0.0, occupiedCells(ends.simulated, {}).set == occupiedCells(ends.measured, {}).set);
    EXPECT_LE(direct, jaccardDistance({.simulated = ends.simulated, .measured = between}) +
                          jaccardDistance({.simulated = between, .measured = ends.measured}) + 1e-15);
  }
}

}  // namespace
