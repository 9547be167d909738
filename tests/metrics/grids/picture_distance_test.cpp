#include "metrics/grids/picture_distance.h"

#include <gtest/gtest.h>
#include <limits>

#include "tests/metrics/grids/random_grids.h"

namespace {

using metrics::CellMask;
using metrics::colourDistance;
using metrics::occupiedPictureDistance;
using metrics::pictureDistance;
using metrics::unoccupiedPictureDistance;
using metrics_test::grid;
using metrics_test::inverse;
using metrics_test::RandomGrids;
using metrics_test::TwoGrids;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

double between(const CellMask& simulated, const CellMask& measured) {
  return colourDistance({.simulated = simulated, .measured = measured});
}

/// A picture with one set cell.
CellMask point(std::size_t row, std::size_t column) {
  CellMask mask = {.rows = 12, .columns = 20, .set = std::vector<std::uint8_t>(240, 0)};
  mask.set[row * mask.columns + column] = 1;
  return mask;
}

TEST(ColourDistance, OfTwoPointsIsTwiceTheirManhattanDistance) {
  EXPECT_EQ(between(point(3, 4), point(3, 4)), 0.0);
  EXPECT_EQ(between(point(3, 4), point(5, 4)), 4.0);
  EXPECT_EQ(between(point(3, 9), point(5, 4)), 14.0);
}

// One way every cell is hit; the other way one cell of three is 4 away.
TEST(ColourDistance, OfAPartSeesTheRestInOneDirectionOnly) {
  const CellMask part = {.rows = 1, .columns = 8, .set = {1, 1, 0, 0, 0, 0, 0, 0}};
  const CellMask whole = {.rows = 1, .columns = 8, .set = {1, 1, 0, 0, 0, 1, 0, 0}};
  EXPECT_DOUBLE_EQ(between(part, whole), 4.0 / 3.0);
}

TEST(ColourDistance, IsSymmetricAndZeroOnlyForEqualPictures) {
  RandomGrids cases(211);
  for (int k = 0; k < 200; ++k) {
    const std::size_t rows = cases.edge();
    const std::size_t columns = cases.edge();
    const CellMask a = cases.mask(rows, columns, 0.3);
    const CellMask b = cases.mask(rows, columns, 0.3);
    EXPECT_EQ(between(a, b), between(b, a));
    EXPECT_EQ(between(a, a), 0.0);
    EXPECT_EQ(between(a, b) == 0.0, a.set == b.set);
  }
}

TEST(ColourDistance, ToAnEmptyPictureIsInfiniteAndOfTwoEmptyOnesZero) {
  CellMask empty = point(3, 3);
  empty.set.assign(empty.set.size(), 0);
  EXPECT_EQ(between(empty, point(3, 3)), kInfinite);
  EXPECT_EQ(between(point(3, 3), empty), kInfinite);
  EXPECT_EQ(between(empty, empty), 0.0);
}

// The post moves by two cells, both ways; of the three free cells two stay and one goes from cell 2 to cell 0, 1 away
// from the nearest free cell of the other grid.
TEST(PictureDistance, IsTheSumOfOccupiedAndFreeColours) {
  const TwoGrids both = {.simulated = grid(1, 5, {0.9, 0.1, 0.1, 0.5, 0.1}),
                         .measured = grid(1, 5, {0.1, 0.1, 0.9, 0.5, 0.1})};
  EXPECT_EQ(occupiedPictureDistance(both.pair()), 4.0);
  EXPECT_DOUBLE_EQ(unoccupiedPictureDistance(both.pair()), 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(pictureDistance(both.pair()), 4.0 + 2.0 / 3.0);
}

TEST(PictureDistance, ExchangesItsColoursWithTheProbabilities) {
  RandomGrids cases(212);
  for (int k = 0; k < 100; ++k) {
    const TwoGrids both = cases.two();
    EXPECT_EQ(occupiedPictureDistance(both.pair()), unoccupiedPictureDistance(inverse(both).pair()));
  }
}

TEST(PictureDistance, UnknownCellsAreNoColour) {
  const TwoGrids moved = {.simulated = grid(1, 4, {0.9, 0.1, 0.5, 0.5}), .measured = grid(1, 4, {0.9, 0.1, 0.5, 0.1})};
  EXPECT_EQ(occupiedPictureDistance(moved.pair()), 0.0);
  EXPECT_EQ(unoccupiedPictureDistance(moved.pair()), 1.0);  // one of two free cells is 2 away
  const TwoGrids nothing = {.simulated = grid(1, 2, {0.5, 0.5}), .measured = grid(1, 2, {0.9, 0.1})};
  EXPECT_EQ(pictureDistance(nothing.pair()), kInfinite);
}

}  // namespace
