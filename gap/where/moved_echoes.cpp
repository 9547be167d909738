#include "gap/where/moved_echoes.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace gap {

namespace {

using Row = ResidualTable::Row;

/// Echoes of one beam that only one side has, beyond noise, cell by cell.
struct Gone {
  std::vector<Row*> rows;
  double per_shot = 0.0;

  void add(Row& row) {
    rows.push_back(&row);
    per_shot += std::abs(row.value);
  }
  /// What is left of them once so many of them moved.
  void reduceBy(double moved) const {
    for (Row* row : rows) row->value *= 1.0 - moved / per_shot;
  }
  [[nodiscard]] const Row& largest() const {
    return **std::max_element(rows.begin(), rows.end(),
                              [](const Row* a, const Row* b) { return std::abs(a->value) < std::abs(b->value); });
  }
};

struct Mean {
  double value = 0.0;
  double variance = 0.0;  ///< of the mean
};

/// Of the echoes that only one side has, from that side's statistics of their cells; ranges there count from the
/// surface.
Mean meanOf(const Gone& gone, const std::vector<Cell>& cells, const std::vector<CellStatistics>& statistics,
            Channel channel) {
  Mean mean;
  for (const Row* row : gone.rows) {
    const CellStatistics& cell = statistics[row->cell];
    const double share = std::abs(row->value) / gone.per_shot;
    mean.value += share * (cell.mean(channel) + (channel == kRange ? cells[row->cell].anchor_m : 0.0));
    mean.variance += share * share * cell.variance(channel) / cell.count;
  }
  return mean;
}

struct Exchange {
  Gone went, came;
};

ResidualTable* find(std::vector<ResidualTable>& tables, const std::string& measurand, const std::string& component) {
  const auto table =
      std::find_if(tables.begin(), tables.end(), [&](const ResidualTable& t) { return t.isOf(measurand, component); });
  return table == tables.end() ? nullptr : &*table;
}

}  // namespace

std::vector<ResidualTable> withMovedEchoes(const Replay& replay, std::vector<ResidualTable> tables,
                                           const CellsOfSamples& measured, const CellsOfSamples& simulated) {
  ResidualTable* const missing = find(tables, "existence", "missing");
  ResidualTable* const extra = find(tables, "existence", "extra");
  if (!missing || !extra) return tables;
  std::map<std::pair<std::size_t, std::uint32_t>, Exchange> by_beam;
  const auto exchangeOf = [&](const Row& row) -> Exchange& {
    return by_beam[{row.sample, replay.samples()[row.sample].layout->cells()[row.cell].beam}];
  };
  for (Row& row : missing->rows)
    if (row.value < -kBeyondNoise * row.error) exchangeOf(row).went.add(row);
  for (Row& row : extra->rows)
    if (row.value > kBeyondNoise * row.error) exchangeOf(row).came.add(row);
  for (const auto& [beam, exchange] : by_beam) {
    const auto& [went, came] = exchange;
    const double moved = std::min(went.per_shot, came.per_shot);
    if (moved <= 0.0) continue;
    const std::vector<Cell>& cells = replay.samples()[beam.first].layout->cells();
    const Row& place = went.largest();  // what the simulation expects there
    for (const Channel channel : replay.channels()) {
      const Mean from = meanOf(went, cells, simulated[beam.first], channel);
      const Mean to = meanOf(came, cells, measured[beam.first], channel);
      ResidualTable* const table = find(tables, measurandOf(replay, channel).name, "bias");
      const double error = std::sqrt(from.variance + to.variance + std::pow(replay.resolution(channel), 2.0));
      table->rows.push_back({place.sample, place.cell, to.value - from.value, error, moved * place.weight});
    }
    went.reduceBy(moved);
    came.reduceBy(moved);
  }
  return tables;
}

}  // namespace gap
