#include "metrics/grids/occupancy_grid.h"

#include <cmath>
#include <gtest/gtest.h>

#include "metrics/grids/cell_ratios.h"
#include "metrics/grids/map_score.h"
#include "metrics/grids/picture_distance.h"
#include "tests/metrics/grids/random_grids.h"
#include "tests/support/thrown_message.h"

namespace {

using metrics::CellLimits;
using metrics::freeCells;
using metrics::GridPair;
using metrics::OccupancyGrid;
using metrics::occupiedCells;
using metrics::requireComparable;
using metrics_test::grid;
using test_support::thrownMessage;

TEST(OccupancyGrid, UnknownCellsAreNeitherOccupiedNorFree) {
  const OccupancyGrid cells = grid(1, 4, {0.4, 0.5, 0.6, 1.0});
  EXPECT_EQ(occupiedCells(cells, {}).set, (std::vector<std::uint8_t>{0, 0, 1, 1}));
  EXPECT_EQ(freeCells(cells, {}).set, (std::vector<std::uint8_t>{1, 0, 0, 0}));
  EXPECT_EQ(occupiedCells(cells, {.occupied_above = 0.8, .free_below = 0.2}).count(), 1u);
  EXPECT_EQ(freeCells(cells, {.occupied_above = 0.8, .free_below = 0.2}).count(), 0u);
}

TEST(OccupancyGrid, WhatDoesNotCompareIsRefusedAndSaysWhere) {
  const OccupancyGrid good = grid(2, 2, {0.1, 0.2, 0.3, 0.4});
  const auto message = [&](const OccupancyGrid& other) {
    return thrownMessage([&] { requireComparable({.simulated = good, .measured = other}); });
  };
  EXPECT_EQ(message(good), "");
  EXPECT_EQ(message(grid(2, 2, {0.1, 0.2, 1.5, 0.4})).rfind("measured grid, row 2, column 1: has the occupancy", 0),
            0u);
  EXPECT_NE(message(grid(2, 2, {0.1, std::nan(""), 0.3, 0.4})).find("row 1, column 2"), std::string::npos);
  EXPECT_NE(message(grid(2, 2, {0.1, 0.2, 0.3})).find("has 3 numbers for 2 x 2 cells"), std::string::npos);
  EXPECT_NE(message(grid(2, 2, {0.1, 0.2, 0.3, 0.4, 0.5})).find("has 5 numbers for 2 x 2 cells"), std::string::npos);
  EXPECT_NE(message(grid(1, 4, {0.1, 0.2, 0.3, 0.4})).find("have 2 x 2 and 1 x 4 cells"), std::string::npos);
  EXPECT_NE(message(grid(0, 4, {})).find("has 0 x 4 cells"), std::string::npos);
}

TEST(OccupancyGrid, CellsOfDifferentOrNoSizeAreRefused) {
  const auto message = [](double simulated_m, double measured_m) {
    OccupancyGrid simulated = grid(1, 1, {0.1});
    OccupancyGrid measured = simulated;
    simulated.cell_size_m = simulated_m;
    measured.cell_size_m = measured_m;
    return thrownMessage([&] { requireComparable({.simulated = simulated, .measured = measured}); });
  };
  EXPECT_NE(message(0.1, 0.2).find("have cells of 0.1 m and 0.2 m"), std::string::npos);
  for (const double size_m : {0.0, -0.1, std::nan("")}) EXPECT_NE(message(size_m, size_m), "");
}

TEST(OccupancyGrid, EveryMetricRefusesGridsThatDoNotCompare) {
  const OccupancyGrid four = grid(2, 2, {0.1, 0.2, 0.3, 0.4});
  const OccupancyGrid two = grid(1, 2, {0.1, 0.2});
  const GridPair pair = {.simulated = four, .measured = two};
  using OfClasses = double (*)(const GridPair&, const CellLimits&);
  for (const OfClasses metric : {OfClasses{metrics::occupiedCellsRatio}, OfClasses{metrics::freeCellsRatio},
                                 OfClasses{metrics::jaccardDistance}, OfClasses{metrics::occupiedPictureDistance},
                                 OfClasses{metrics::unoccupiedPictureDistance}, OfClasses{metrics::pictureDistance}}) {
    EXPECT_NE(thrownMessage([&] { (void)metric(pair, {}); }), "");
  }
  EXPECT_NE(thrownMessage([&] { (void)metrics::mapScore(pair); }), "");
}

TEST(OccupancyGrid, ExchangedLimitsAreRefused) {
  const OccupancyGrid cells = grid(1, 1, {0.4});
  for (const CellLimits& limits : {CellLimits{.occupied_above = 0.2, .free_below = 0.8},
                                   CellLimits{.occupied_above = 1.2}, CellLimits{.free_below = -0.1}}) {
    EXPECT_NE(thrownMessage([&] { (void)occupiedCells(cells, limits); }), "");
    EXPECT_NE(thrownMessage([&] { (void)freeCells(cells, limits); }), "");
  }
}

}  // namespace
