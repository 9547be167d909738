#include "metrics/points/transport.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numeric>

namespace metrics {

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

/// Rows and columns are nodes. A unit may go from any row to any column, and back along what was shipped already.
/// Prices keep the reduced cost of every arc that can be used >= 0, and = 0 where something is shipped.
class Transport {
 public:
  Transport(const CostTable& costs, std::vector<std::int64_t> supply, std::vector<std::int64_t> capacity)
      : costs_(costs),
        supply_(std::move(supply)),
        room_(std::move(capacity)),
        row_price_(costs.rows()),
        column_price_(costs.columns()),
        shipped_(costs.columns()) {
    for (std::size_t i = 0; i < costs.rows(); ++i) {
      double cheapest = kFar;
      for (std::size_t j = 0; j < costs.columns(); ++j) cheapest = std::min(cheapest, costs(i, j));
      row_price_[i] = cheapest;
    }
  }

  std::vector<Shipment> solve() {
    for (std::size_t i = 0; i < supply_.size(); ++i) {
      while (supply_[i] > 0) augment(i);
    }
    std::vector<Shipment> all;
    for (const auto& column : shipped_) all.insert(all.end(), column.begin(), column.end());
    return all;
  }

 private:
  void augment(std::size_t source) {
    const std::size_t target = shortestPath(source);
    adjustPrices(column_distance_[target]);
    ship(source, target, bottleneck(source, target));
  }

  /// Dijkstra on the dense graph, from one row to the nearest column with room.
  std::size_t shortestPath(std::size_t source) {
    row_distance_.assign(costs_.rows(), kFar);
    column_distance_.assign(costs_.columns(), kFar);
    from_column_.assign(costs_.rows(), kNone);
    from_row_.assign(costs_.columns(), kNone);
    open_.resize(costs_.columns());
    std::iota(open_.begin(), open_.end(), std::size_t{0});
    reach(source, 0.0, kNone);
    for (;;) {
      const std::size_t column = takeNearest();
      if (room_[column] > 0) return column;
      for (const Shipment& back : shipped_[column]) {
        if (row_distance_[back.row] == kFar) reach(back.row, column_distance_[column], column);
      }
    }
  }

  void reach(std::size_t row, double distance, std::size_t from) {
    row_distance_[row] = distance;
    from_column_[row] = from;
    for (const std::size_t j : open_) {
      const double reduced = std::max(0.0, costs_(row, j) - row_price_[row] - column_price_[j]);  // rounding: -1e-16
      if (distance + reduced < column_distance_[j]) {
        column_distance_[j] = distance + reduced;
        from_row_[j] = row;
      }
    }
  }

  std::size_t takeNearest() {
    std::size_t best = 0;
    for (std::size_t k = 1; k < open_.size(); ++k) {
      const double here = column_distance_[open_[k]];
      const double least = column_distance_[open_[best]];
      if (here < least || (here == least && open_[k] < open_[best])) best = k;
    }
    const std::size_t column = open_[best];
    open_[best] = open_.back();
    open_.pop_back();
    return column;
  }

  void adjustPrices(double target_distance) {
    for (std::size_t i = 0; i < row_price_.size(); ++i) {
      if (row_distance_[i] < target_distance) row_price_[i] += target_distance - row_distance_[i];
    }
    for (std::size_t j = 0; j < column_price_.size(); ++j) {
      if (column_distance_[j] < target_distance) column_price_[j] -= target_distance - column_distance_[j];
    }
  }

  /// How many units the path from source to target can take.
  std::int64_t bottleneck(std::size_t source, std::size_t target) {
    std::int64_t units = std::min(supply_[source], room_[target]);
    for (std::size_t row = from_row_[target]; row != source; row = from_row_[from_column_[row]]) {
      units = std::min(units, shipment(row, from_column_[row])->units);
    }
    return units;
  }

  void ship(std::size_t source, std::size_t target, std::int64_t units) {
    supply_[source] -= units;
    room_[target] -= units;
    std::size_t column = target;
    for (std::size_t row = from_row_[target];; row = from_row_[column]) {
      add(row, column, units);
      if (row == source) return;
      column = from_column_[row];
      const auto back = shipment(row, column);
      back->units -= units;
      if (back->units == 0) shipped_[column].erase(back);
    }
  }

  void add(std::size_t row, std::size_t column, std::int64_t units) {
    const auto present = shipment(row, column);
    if (present == shipped_[column].end()) {
      shipped_[column].push_back({.row = row, .column = column, .units = units});
    } else {
      present->units += units;
    }
  }

  std::vector<Shipment>::iterator shipment(std::size_t row, std::size_t column) {
    return std::ranges::find(shipped_[column], row, &Shipment::row);
  }

  const CostTable& costs_;
  std::vector<std::int64_t> supply_;
  std::vector<std::int64_t> room_;
  std::vector<double> row_price_;
  std::vector<double> column_price_;
  std::vector<std::vector<Shipment>> shipped_;  // by column

  // The tree of shortest paths of the current augmentation.
  std::vector<double> row_distance_;
  std::vector<double> column_distance_;
  std::vector<std::size_t> from_column_;  // of a row
  std::vector<std::size_t> from_row_;     // of a column
  std::vector<std::size_t> open_;         // columns not yet taken
};

}  // namespace

CostTable::CostTable(std::size_t rows, std::size_t columns, const std::function<double(std::size_t, std::size_t)>& cost)
    : rows_(rows), columns_(columns) {
  costs_.reserve(rows * columns);
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) costs_.push_back(cost(i, j));
  }
}

std::vector<Shipment> cheapestTransport(const CostTable& costs, std::vector<std::int64_t> supply,
                                        std::vector<std::int64_t> capacity) {
  assert(supply.size() == costs.rows() && capacity.size() == costs.columns());
  assert(std::reduce(supply.begin(), supply.end()) <= std::reduce(capacity.begin(), capacity.end()));
  return Transport(costs, std::move(supply), std::move(capacity)).solve();
}

std::vector<std::optional<std::size_t>> optimalAssignment(const CostTable& costs) {
  std::vector<std::optional<std::size_t>> column_of(costs.rows());
  if (costs.rows() <= costs.columns()) {
    const auto all = cheapestTransport(costs, std::vector<std::int64_t>(costs.rows(), 1),
                                       std::vector<std::int64_t>(costs.columns(), 1));
    for (const Shipment& one : all) column_of[one.row] = one.column;
    return column_of;
  }
  const CostTable turned(costs.columns(), costs.rows(), [&](std::size_t i, std::size_t j) { return costs(j, i); });
  const auto all = cheapestTransport(turned, std::vector<std::int64_t>(costs.columns(), 1),
                                     std::vector<std::int64_t>(costs.rows(), 1));
  for (const Shipment& one : all) column_of[one.column] = one.row;
  return column_of;
}

}  // namespace metrics
