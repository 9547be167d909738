#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace metrics {

/// A picture in two colours: which cells of a grid belong to a class, row by row.
struct CellMask {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<std::uint8_t> set;  ///< 1: the cell belongs to the class

  [[nodiscard]] std::size_t count() const {
    return static_cast<std::size_t>(std::count(set.begin(), set.end(), std::uint8_t{1}));
  }
};

/// The mask of `rows` x `columns` cells with those set whose number satisfies `belongs`.
template <typename Belongs>
CellMask maskWhere(std::size_t rows, std::size_t columns, const std::vector<double>& numbers, Belongs belongs) {
  CellMask mask = {.rows = rows, .columns = columns, .set = {}};
  mask.set.reserve(numbers.size());
  for (const double number : numbers) mask.set.push_back(belongs(number) ? 1 : 0);
  return mask;
}

}  // namespace metrics
