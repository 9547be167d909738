#include "gap/where/where.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gap/distance/settle.h"
#include "gap/where/moved_echoes.h"
#include "gap/where/near_echoes.h"

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

/// In standard errors.
double deviationOf(const Row& row) { return row.error > 0.0 ? row.value / row.error : 0.0; }

std::pair<std::size_t, std::size_t> placeOf(const Row* row) { return {row->sample, row->cell}; }

/// The rows of a table by place; a place where echoes moved has two.
std::vector<const Row*> byPlace(const ResidualTable& table) {
  std::vector<const Row*> rows;
  for (const Row& row : table.rows) rows.push_back(&row);
  std::stable_sort(rows.begin(), rows.end(), [](const Row* a, const Row* b) { return placeOf(a) < placeOf(b); });
  return rows;
}

/// How far a cause changes a table, which was simulated twice: the product of both residuals in standard errors, z²,
/// each for the echoes of a shot that it concerns and by the loss of Cauchy's distribution, log(1 + z²/2), which hardly
/// grows with what is far out already. So a step or two in every beam is more than metres in a few, where two echoes
/// are one or two by a hair; and where the cause makes the noise another one (air that sends light back has its own),
/// its products have any sign and add up to nothing. Echoes come and go by chance where a cause is rare, so of
/// existence one simulation tells; only the sign that the component has counts, for what may be noise stands in both.
double changeIn(const ResidualTable& table, const ResidualTable& once_more, const std::vector<int>& frames) {
  const std::vector<const Row*> others = byPlace(once_more);
  auto other = others.begin();
  double sum = 0.0;
  for (const Row* row : byPlace(table)) {
    while (other != others.end() && placeOf(*other) < placeOf(row)) ++other;
    const bool again = other != others.end() && placeOf(*other) == placeOf(row);
    const double second = again ? deviationOf(**other++) : 0.0;
    const double first = deviationOf(*row), product = first * (table.sign() == 0.0 ? second : first);
    if (table.sign() * row->value >= 0.0)
      sum += row->weight / frames[row->sample] * std::copysign(std::log1p(0.5 * std::abs(product)), product);
  }
  return sum;
}

/// Of two worlds under the same noise: all that differs is a residual, but for what its component does not count.
ResidualTable withoutNoise(ResidualTable change) {
  for (Row& row : change.rows) {
    row.error = 0.0;
    if (change.sign() * row.value < 0.0) row.value = 0.0;
  }
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
      result.near_echoes_m = lossOfNearEchoes_m(replay, table, result.expected);
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
  std::vector<ResidualTable> tables = differences(with.expected, without.expected);
  const std::vector<ResidualTable> once_more = differences(with.once_more, without.once_more);
  std::vector<TableChange> changes;
  double most = 0.0;
  for (ResidualTable& table : tables) {
    const auto other = std::find_if(once_more.begin(), once_more.end(),
                                    [&](const ResidualTable& t) { return t.isOf(table.measurand, table.component); });
    if (other == once_more.end()) continue;
    const double change = changeIn(table, *other, with.frames);
    most = std::max(most, change);
    changes.push_back({withoutNoise(std::move(table)), change});
  }
  std::erase_if(changes,
                [&](const TableChange& change) { return change.size < kChanges * most || change.size <= 0.0; });
  return whereRows(replay, without.by_beam, without.expected, changes);
}

}  // namespace gap
