#include "gap/where/where.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gap/distance/settle.h"
#include "gap/where/moved_echoes.h"

namespace gap {

namespace {

constexpr int kWhereFrames = 24;
constexpr std::uint64_t kOtherNoise = 5000;  // added to the seed
constexpr double kChanges = 1e-3;            // of what a cause changes most: less is no change

CellsOfSamples measuredCells(const Replay& replay) {
  CellsOfSamples cells;
  for (const ReplaySample& sample : replay.samples()) cells.push_back(sample.statistics);
  return cells;
}

std::vector<int> measuredFrames(const Replay& replay) {
  std::vector<int> frames;
  for (const ReplaySample& sample : replay.samples()) frames.push_back(sample.frames);
  return frames;
}

double falseEchoesPerShot(const Replay& replay, const CellsOfSamples& expected, const std::vector<int>& frames) {
  double shots = 0.0, more = 0.0;
  for (std::size_t s = 0; s < replay.samples().size(); ++s) {
    const ReplaySample& sample = replay.samples()[s];
    for (std::size_t c = sample.layout->surfaces(); c < sample.statistics.size(); ++c) {  // one for each beam
      if (sample.layout->cells()[c].at_edge) continue;
      shots += sample.frames;
      more += sample.statistics[c].count - expected[s][c].count * sample.frames / frames[s];
    }
  }
  return shots > 0.0 ? std::max(0.0, more / shots) : 0.0;
}

using Row = ResidualTable::Row;

std::pair<std::size_t, std::size_t> placeOf(const Row* row) { return {row->sample, row->cell}; }

/// The rows of a table by place; a place where echoes moved may have two.
std::vector<const Row*> byPlace(const ResidualTable& table) {
  std::vector<const Row*> rows;
  for (const Row& row : table.rows) rows.push_back(&row);
  std::stable_sort(rows.begin(), rows.end(), [](const Row* a, const Row* b) { return placeOf(a) < placeOf(b); });
  return rows;
}

/// What a cause changes in one place, in two simulations; a second that does not show it is nothing.
struct Twice {
  const Row* first;
  Row second{};

  /// The product of both in standard errors, z² under the same noise.
  [[nodiscard]] double product() const {
    if (first->error <= 0.0 || second.error <= 0.0) return 0.0;
    return first->value / first->error * (second.value / second.error);
  }
  /// What both show.
  [[nodiscard]] double common() const {
    if (first->value * second.value <= 0.0) return 0.0;
    return std::copysign(std::min(std::abs(first->value), std::abs(second.value)), first->value);
  }
};

std::vector<Twice> pairedByPlace(const ResidualTable& table, const ResidualTable& once_more) {
  const std::vector<const Row*> others = byPlace(once_more);
  auto other = others.begin();
  std::vector<Twice> paired;
  for (const Row* row : byPlace(table)) {
    while (other != others.end() && placeOf(*other) < placeOf(row)) ++other;
    paired.push_back({row});
    if (other != others.end() && placeOf(*other) == placeOf(row)) paired.back().second = **other++;
  }
  return paired;
}

/// The loss of Cauchy's distribution, log(1 + z²/2), with the sign of what stands for z².
double robust(double product) { return std::copysign(std::log1p(0.5 * std::abs(product)), product); }

/// What a cause changes of values, and how far: z² of both simulations, each for the echoes of a shot that it concerns
/// and by a loss that hardly grows with what is far out already. So a step or two in every beam is more than metres in
/// a few, where two echoes are one or two by a hair; and where the cause makes the noise another one (air that sends
/// light back has its own), products have any sign and add up to hardly anything: less than two standard errors is no
/// change.
TableChange changeOfValues(const ResidualTable& table, const ResidualTable& once_more, const std::vector<int>& frames) {
  constexpr std::size_t kFewPlaces = 4;  // less is known of fewer: a false target may change one
  TableChange change{{table.measurand, table.component, table.unit, table.scale, {}}, 0.0};
  double squares = 0.0;
  std::size_t places = 0;
  for (const Twice& twice : pairedByPlace(table, once_more)) {
    const double term = twice.first->weight / frames[twice.first->sample] * robust(twice.product());
    change.size += term;
    squares += term * term;
    places += term != 0.0 ? 1 : 0;
    Row row = *twice.first;
    row.value = twice.common();
    row.error = 0.0;
    change.table.rows.push_back(row);
  }
  if (places > kFewPlaces && change.size < 2.0 * std::sqrt(squares)) change.size = 0.0;
  return change;
}

/// The same of echoes. They come and go by chance where a cause is rare, so one simulation tells; only the sign that
/// the component has counts, for what may be noise stands in both.
TableChange changeOfEchoes(ResidualTable table, const std::vector<int>& frames) {
  TableChange change{{}, 0.0};
  for (Row& row : table.rows) {
    if (table.sign() * row.value < 0.0) row.value = 0.0;
    if (row.error > 0.0) change.size += row.weight / frames[row.sample] * robust(std::pow(row.value / row.error, 2.0));
    row.error = 0.0;
  }
  change.table = std::move(table);
  return change;
}

}  // namespace

WhereResult whereIn(const Replay& replay, const World& world, std::uint64_t seed) {
  const CellsOfSamples measured = measuredCells(replay);
  CellsOfSamples simulated(replay.samples().size());
  WhereResult result;
  std::vector<int>& frames = result.frames;
  std::vector<Comparison> comparisons;
  for (std::size_t s = 0; s < replay.samples().size(); ++s) {
    const ReplaySample& sample = replay.samples()[s];
    frames.push_back(std::clamp(sample.frames, 3, kWhereFrames));
    comparisons.push_back({s, sample.statistics, sample.frames, replay.simulate(world, s, frames[s], seed), frames[s]});
  }
  for (const Comparison& comparison : comparisons) result.once_more.push_back(comparison.simulated);
  settle(replay, world, comparisons, {});
  for (std::size_t s = 0; s < simulated.size(); ++s) {
    simulated[s] = std::move(comparisons[s].simulated);
    result.expected.push_back(replay.simulate(world, s, frames[s], seed + kOtherNoise));
  }
  result.tables = residualTables(replay, {measured, measuredFrames(replay), simulated, frames});
  result.by_beam = withMovedEchoes(replay, result.tables, measured, simulated);
  result.rows = whereRows(replay, result.by_beam, result.expected);
  result.sectors = sectorsIn(replay, result.tables);
  result.unexpected = unexpectedEchoes(replay, result.expected, frames);
  result.false_echoes_per_shot = falseEchoesPerShot(replay, result.expected, frames);
  for (const ResidualTable& table : result.tables) {
    if (table.component == "missing") {
      result.gate = gateIn(replay, table);
      result.near_echoes = lossOfNearEchoes(replay, table, result.expected);
    }
    result.largest_steps = std::max({result.largest_steps, table.excess(), table.commonShift()});
  }
  for (const WhereRow& row : result.rows) {
    for (const ResidualTable& table : result.tables) {
      if (!table.isOf(row.measurand, row.component) || row.mayBeChance()) continue;
      result.largest_steps = std::max(result.largest_steps, std::abs(row.value) / table.scale);
    }
  }
  return result;
}

std::vector<WhereRow> rowsOfCause(const Replay& replay, const WhereResult& without, const WhereResult& with) {
  const auto differences = [&](const CellsOfSamples& cause, const CellsOfSamples& none) {
    return withMovedEchoes(replay, residualTables(replay, {cause, with.frames, none, without.frames}), cause, none);
  };
  const std::vector<ResidualTable> once_more = differences(with.once_more, without.once_more);
  std::vector<TableChange> changes;
  double most = 0.0;
  for (ResidualTable& table : differences(with.expected, without.expected)) {
    const ResidualTable* const other = sameOf(once_more, table);
    if (!other) continue;
    changes.push_back(table.sign() == 0.0 ? changeOfValues(table, *other, with.frames)
                                          : changeOfEchoes(std::move(table), with.frames));
    most = std::max(most, changes.back().size);
  }
  std::erase_if(changes,
                [&](const TableChange& change) { return change.size < kChanges * most || change.size <= 0.0; });
  return whereRows(replay, without.by_beam, without.expected, changes);
}

}  // namespace gap
