#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace metrics {

/// What it costs to take one unit from row i to column j. Any finite numbers; row by row.
class CostTable {
 public:
  CostTable(std::size_t rows, std::size_t columns, const std::function<double(std::size_t, std::size_t)>& cost);

  [[nodiscard]] std::size_t rows() const noexcept { return rows_; }
  [[nodiscard]] std::size_t columns() const noexcept { return columns_; }
  [[nodiscard]] double operator()(std::size_t i, std::size_t j) const noexcept { return costs_[i * columns_ + j]; }

 private:
  std::size_t rows_;
  std::size_t columns_;
  std::vector<double> costs_;
};

struct Shipment {
  std::size_t row;
  std::size_t column;
  std::int64_t units;  ///< > 0
};

/// The cheapest way to ship every unit of `supply` (one number a row) to columns that take at most `capacity` each.
/// Exact: successive shortest paths on reduced costs. Ties go to the smaller index, so the result is a pure function of
/// the table. O(k (r + c) c) for k augmentations, k = r for an assignment.
/// The supply must fit into the capacity. Shipments come column by column.
/// Source: Ahuja, Magnanti & Orlin 1993, Network Flows, ch. 9 (successive shortest path algorithm).
[[nodiscard]] std::vector<Shipment> cheapestTransport(const CostTable& costs, std::vector<std::int64_t> supply,
                                                      std::vector<std::int64_t> capacity);

/// Optimal assignment: the transport of one unit. Gives every row its own column, or, if there are more rows than
/// columns, every column its own row; the sum of costs is least. Absent: the row got none.
/// Source: Jonker & Volgenant 1987, doi:10.1007/BF02278710 (shortest augmenting paths).
[[nodiscard]] std::vector<std::optional<std::size_t>> optimalAssignment(const CostTable& costs);

}  // namespace metrics
