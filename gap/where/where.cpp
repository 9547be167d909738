#include "gap/where/where.h"

#include <algorithm>
#include <cmath>

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

/// How far a cause changes a table: the residuals in standard errors, each for the echoes of a shot that it concerns
/// and by the loss of Cauchy's distribution, log(1 + z²/2), which hardly grows with what is far out already. So a step
/// or two in every beam is more than metres in a few, where two echoes are one or two by a hair. Of existence only the
/// sign that the component has: what may be noise stands in both.
double changeIn(const ResidualTable& table, const std::vector<int>& frames) {
  double sum = 0.0;
  for (const ResidualTable::Row& row : table.rows)
    if (row.error > 0.0 && table.sign() * row.value >= 0.0)
      sum += row.weight / frames[row.sample] * std::log1p(0.5 * std::pow(row.value / row.error, 2.0));
  return sum;
}

/// Of two worlds under the same noise: all that differs is a residual, but for what its component does not count.
ResidualTable withoutNoise(ResidualTable change) {
  for (ResidualTable::Row& row : change.rows) {
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
  const auto tables = residualTables(replay, {with.expected, with.frames, without.expected, without.frames});
  std::vector<TableChange> changes;
  double most = 0.0;
  for (ResidualTable& table : withMovedEchoes(replay, tables, with.expected, without.expected)) {
    const double change = changeIn(table, with.frames);
    most = std::max(most, change);
    changes.push_back({withoutNoise(std::move(table)), change});
  }
  std::erase_if(changes,
                [&](const TableChange& change) { return change.size < kChanges * most || change.size == 0.0; });
  return whereRows(replay, without.by_beam, without.expected, changes);
}

}  // namespace gap
