#include "metrics/grids/grid_shape.h"

#include "core/error.h"

namespace metrics {

namespace {

std::string toString(const GridShape& shape) {
  return std::to_string(shape.rows) + " x " + std::to_string(shape.columns);
}

void requireWhole(const GridShape& shape, const std::string& name) {
  if (shape.rows == 0 || shape.columns == 0) {
    throw core::InputError({.item = name}, "has " + toString(shape) + " cells.", "Give at least one row and column.");
  }
  if (shape.numbers / shape.columns == shape.rows && shape.numbers % shape.columns == 0) return;
  throw core::InputError({.item = name},
                         "has " + std::to_string(shape.numbers) + " numbers for " + toString(shape) + " cells.",
                         "Give one number for each cell, row by row.");
}

}  // namespace

void requireSameShape(const GridShape& simulated, const GridShape& measured, const std::string& what) {
  requireWhole(simulated, "simulated " + what);
  requireWhole(measured, "measured " + what);
  if (simulated.rows == measured.rows && simulated.columns == measured.columns) return;
  throw core::InputError(
      {.item = "simulated and measured " + what},
      "have " + toString(simulated) + " and " + toString(measured) + " cells; they are compared cell by cell.",
      "Cut or resample both to the same rows and columns.");
}

std::string cellName(const std::string& grid, std::size_t index, std::size_t columns) {
  return grid + ", row " + std::to_string(index / columns + 1) + ", column " + std::to_string(index % columns + 1);
}

}  // namespace metrics
