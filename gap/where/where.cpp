#include "gap/where/where.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "gap/distance/discrepancy.h"
#include "gap/distance/settle.h"
#include "gap/replay/statistics.h"
#include "gap/where/covariates.h"
#include "gap/where/gate.h"
#include "gap/where/moved_echoes.h"
#include "gap/where/sectors.h"

namespace gap {

namespace {

constexpr std::size_t kQuantileGroups = 16;
constexpr double kSmallestExcess = 0.1;  // of the resolution: less is not worth a row
constexpr int kWhereFrames = 24;
constexpr std::uint64_t kOtherNoise = 5000;  // added to the seed
constexpr double kChanges = 1e-3;            // of what a cause changes most: less is no change
constexpr double kExistenceScale = 0.01;     // the total gap counts existence in per cent of the simulated echoes

using Row = ResidualTable::Row;

/// What of a residual its noise does not explain.
double beyondError(const Row& row) {
  return std::sqrt(std::max(0.0, row.value * row.value - 4.0 * row.error * row.error));
}

double totalGapOf(const std::vector<Row>& rows) {
  double sum = 0.0;
  for (const Row& row : rows) sum += row.weight * beyondError(row);
  return sum;
}

/// What a row adds to the gap of its table: what its noise does not explain; or, where echoes are so few that no single
/// cell shows them, what it counts, with its sign, so that noise averages out.
class GapOfRows {
 public:
  explicit GapOfRows(const ResidualTable& table) : all_(totalGapOf(table.rows)) {
    if (all_ > 0.0) return;
    sign_ = table.sign();
    for (const Row& row : table.rows) all_ += of(row);
  }
  [[nodiscard]] double of(const Row& row) const {
    return row.weight * (sign_ == 0.0 ? beyondError(row) : sign_ * row.value);
  }
  [[nodiscard]] double all() const { return all_; }

 private:
  double sign_ = 0.0;
  double all_;
};

/// A group of rows with adjacent values (or one name).
struct Group {
  double low = 0.0, high = 0.0;
  std::string name;
  double gap = 0.0, weight = 0.0, value = 0.0, variance = 0.0;  // sums

  void add(const Row& row, const GapOfRows& gaps) {
    gap += gaps.of(row);
    weight += row.weight;
    value += row.weight * row.value;
    variance += row.weight * row.weight * row.error * row.error;
  }
  void add(const Group& other) {
    gap += other.gap;
    weight += other.weight;
    value += other.value;
    variance += other.variance;
  }
};

std::vector<Group> numericGroups(const std::vector<Row>& rows, const Covariate& covariate, const GapOfRows& gaps) {
  std::vector<std::pair<double, const Row*>> sorted;
  double weight = 0.0;
  for (const Row& row : rows) {
    const double x = covariate.number(row);
    if (!std::isfinite(x)) continue;
    sorted.emplace_back(x, &row);
    weight += row.weight;
  }
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Group> groups;
  double passed = 0.0;
  for (const auto& [x, row] : sorted) {
    const auto wanted = static_cast<std::size_t>(passed / weight * kQuantileGroups);
    const bool same_value = !groups.empty() && x - groups.back().high < 1e-9;
    if (groups.empty() || (!same_value && wanted >= groups.size())) groups.push_back({x, x, "", 0, 0, 0, 0});
    groups.back().high = x;
    groups.back().add(*row, gaps);
    passed += row->weight;
  }
  return groups;
}

std::vector<Group> namedGroups(const std::vector<Row>& rows, const Covariate& covariate, const GapOfRows& gaps) {
  std::map<std::string, Group> by_name;
  for (const Row& row : rows) {
    Group& group = by_name[covariate.text(row)];
    group.add(row, gaps);
  }
  std::vector<Group> groups;
  for (auto& [name, group] : by_name) {
    group.name = name;
    groups.push_back(group);
  }
  // Worst first: a set of names is then a prefix.
  std::stable_sort(groups.begin(), groups.end(),
                   [](const Group& a, const Group& b) { return a.gap * b.weight > b.gap * a.weight; });
  return groups;
}

struct Best {
  Group joint;
  std::size_t first = 0, last = 0;
  double lift = -1.0;
  std::size_t tried = 0;
};

/// The run of groups whose share of the gap exceeds its share of the data most. `sign`: of its mean residual; 0: any.
Best bestRun(const std::vector<Group>& groups, double all_gap, double all_weight, bool prefixes_only, double sign) {
  Best best;
  for (std::size_t first = 0; first < (prefixes_only ? 1 : groups.size()); ++first) {
    Group joint;
    for (std::size_t last = first; last < groups.size(); ++last) {
      joint.add(groups[last]);
      if (last - first + 1 == groups.size()) break;  // everything is no stratum
      ++best.tried;
      const double lift = joint.gap / all_gap - joint.weight / all_weight;
      if (sign * joint.value >= 0.0 && lift > best.lift + 1e-12) {
        const std::size_t tried = best.tried;
        best = {joint, first, last, lift, tried};
      }
    }
  }
  return best;
}

/// Covariates that a person thinks in first; they win where two tell the same story.
double readability(const std::string& covariate) {
  if (covariate == "time_s" || covariate == "setup" || covariate == "epw_m" || covariate == "intensity") return 0.85;
  if (covariate == "elevation_deg" || covariate == "material") return 0.95;
  return 1.0;
}

}  // namespace

double ResidualTable::excess() const {
  double weight = 0.0;
  for (const Row& row : rows) weight += row.weight;
  return weight > 0.0 ? totalGapOf(rows) / weight / scale : 0.0;
}

double ResidualTable::sign() const { return component == "missing" ? -1.0 : component == "extra" ? 1.0 : 0.0; }

double ResidualTable::commonShift() const {
  double sum = 0.0, weight = 0.0, variance = 0.0;
  for (const Row& row : rows) {
    sum += row.weight * row.value;
    weight += row.weight;
    variance += row.weight * row.weight * row.error * row.error;
  }
  if (sign() * sum < 0.0) return 0.0;
  return weight > 0.0 && std::abs(sum) > 5.0 * std::sqrt(variance) ? std::abs(sum) / weight / scale : 0.0;
}

const model::Measurand& measurandOf(const Replay& replay, Channel channel) {
  const auto& measurands = replay.experiment().measurands;
  const auto carried = std::find_if(measurands.begin(), measurands.end(), [&](const model::Measurand& m) {
    return m.name == nameOf(channel) || m.column == columnOf(channel);
  });
  return *carried;  // a replay has no other channels
}

namespace {

void addValues(const Replay& replay, const Sides& sides, Channel channel, std::vector<ResidualTable>& tables) {
  const model::Measurand& measurand = measurandOf(replay, channel);
  ResidualTable bias{measurand.name, "bias", measurand.unit, measurand.resolution, {}};
  ResidualTable scatter{measurand.name, "scatter", measurand.unit, measurand.resolution, {}};
  for (std::size_t s = 0; s < replay.samples().size(); ++s) {
    for (std::size_t c = 0; c < replay.samples()[s].layout->surfaces(); ++c) {
      const CellStatistics &m = sides.measured[s][c], &x = sides.simulated[s][c];
      if (m.count == 0.0 || x.count == 0.0) continue;
      bias.rows.push_back(
          {s, c, m.mean(channel) - x.mean(channel), meanError(replay, replay.samples()[s], c, channel, m, x), m.count});
      if (m.count < 5.0 || x.count < 5.0) continue;
      const double sm = std::sqrt(m.variance(channel)), sx = std::sqrt(x.variance(channel));
      const double error =
          std::sqrt(m.variance(channel) / (2.0 * (m.count - 1.0)) + x.variance(channel) / (2.0 * (x.count - 1.0)) +
                    std::pow(0.1 * measurand.resolution, 2.0));
      scatter.rows.push_back({s, c, sm - sx, error, m.count});
    }
  }
  tables.push_back(std::move(bias));
  tables.push_back(std::move(scatter));
}

void addExistence(const Replay& replay, const Sides& sides, std::vector<ResidualTable>& tables) {
  ResidualTable missing{"existence", "missing", "1/shot", kExistenceScale, {}};
  ResidualTable extra{"existence", "extra", "1/shot", kExistenceScale, {}};
  double echoes = 0.0, shots = 0.0;
  for (std::size_t s = 0; s < replay.samples().size(); ++s) {
    const ReplaySample& sample = replay.samples()[s];
    if (sample.layout->pooled()) continue;
    const double of_measured = sides.measured_frames[s], of_simulated = sides.simulated_frames[s];
    for (std::size_t c = 0; c < sample.layout->cells().size(); ++c) {
      const double measured = sides.measured[s][c].count / of_measured;
      const double expected = sides.simulated[s][c].count / of_simulated;
      const double rate = std::clamp(0.5 * (measured + expected), 0.01, 0.99);
      const double error = std::sqrt(rate * (1.0 - rate) * (1.0 / of_measured + 1.0 / of_simulated) + 1e-4);
      const double value = measured - expected;
      echoes += expected * of_measured;
      shots += of_measured;
      // What may be noise stays in both with its sign, so that it averages out: a half of it would look like a loss.
      const bool noise = std::abs(value) < kBeyondNoise * error;
      missing.rows.push_back({s, c, noise ? value : std::min(0.0, value), error, of_measured});
      extra.rows.push_back({s, c, noise ? value : std::max(0.0, value), error, of_measured});
    }
  }
  if (shots > 0.0 && echoes > 0.0) missing.scale = extra.scale = kExistenceScale * echoes / shots;
  if (!missing.rows.empty()) tables.push_back(std::move(missing));
  if (!extra.rows.empty()) tables.push_back(std::move(extra));
}

}  // namespace

std::vector<ResidualTable> residualTables(const Replay& replay, const Sides& sides) {
  std::vector<ResidualTable> tables;
  for (const Channel channel : replay.channels()) addValues(replay, sides, channel, tables);
  addExistence(replay, sides, tables);
  return tables;
}

std::vector<WhereRow> whereRows(const Replay& replay, const std::vector<ResidualTable>& tables,
                                const CellsOfSamples& expected, const SizeOfTables& accounted_for) {
  const std::vector<Covariate> covariates = covariatesOf(replay, expected);
  std::vector<WhereRow> result;
  for (const ResidualTable& table : tables) {
    const GapOfRows gaps(table);
    const double all_gap = gaps.all();
    const bool small = std::max(table.excess(), table.commonShift()) < kSmallestExcess;
    if (all_gap <= 0.0 || (small && !accounted_for.contains({table.measurand, table.component}))) continue;
    double all_weight = 0.0;
    for (const Row& row : table.rows) all_weight += row.weight;
    for (const Covariate& covariate : covariates) {
      const auto groups =
          covariate.numeric ? numericGroups(table.rows, covariate, gaps) : namedGroups(table.rows, covariate, gaps);
      if (groups.size() < 2) continue;
      const Best best = bestRun(groups, all_gap, all_weight, !covariate.numeric, table.sign());
      if (best.lift <= 0.0) continue;
      WhereRow row;
      row.measurand = table.measurand;
      row.component = table.component;
      row.covariate = covariate.name;
      row.numeric = covariate.numeric;
      row.low = groups[best.first].low;
      row.high = groups[best.last].high;
      if (!covariate.numeric) {
        for (std::size_t g = best.first; g <= best.last; ++g) row.names.push_back(groups[g].name);
        std::sort(row.names.begin(), row.names.end());
      }
      row.value = best.joint.value / best.joint.weight;
      row.unit = table.unit;
      row.share = std::min(1.0, best.joint.gap / all_gap);
      row.size = best.joint.weight / all_weight;
      const double z = std::abs(best.joint.value) / std::sqrt(std::max(1e-300, best.joint.variance));
      row.p_value =
          std::min(1.0, 2.0 * upperTail(z) * static_cast<double>(best.tried * covariates.size() * tables.size()));
      row.score = best.lift * readability(covariate.name);
      result.push_back(std::move(row));
    }
  }
  // The measurand with the largest gap first; within it the stratum that concentrates it most, what may be noise last.
  SizeOfTables largest;
  for (const ResidualTable& table : tables) {
    const bool significant = std::any_of(result.begin(), result.end(), [&](const WhereRow& row) {
      return row.measurand == table.measurand && row.component == table.component && !row.mayBeChance();
    });
    largest[{table.measurand, table.component}] = significant ? std::max(table.excess(), table.commonShift()) : 0.0;
  }
  const auto sizeIn = [](const SizeOfTables& sizes, const WhereRow& row) {
    const auto size = sizes.find({row.measurand, row.component});
    return size == sizes.end() ? 0.0 : size->second;
  };
  std::stable_sort(result.begin(), result.end(), [&](const WhereRow& a, const WhereRow& b) {
    const double changes_a = sizeIn(accounted_for, a), changes_b = sizeIn(accounted_for, b);
    const double excess_a = sizeIn(largest, a), excess_b = sizeIn(largest, b);
    const bool sure_a = !a.mayBeChance(), sure_b = !b.mayBeChance();
    if (changes_a != changes_b) return changes_a > changes_b;
    if (excess_a != excess_b) return excess_a > excess_b;
    return sure_a != sure_b ? sure_a : a.score > b.score;
  });
  return result;
}

namespace {

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
    shots += sample.frames * static_cast<double>(sample.beams.size());
    for (std::size_t c = sample.layout->surfaces(); c < sample.statistics.size(); ++c) {
      if (!sample.layout->cells()[c].at_edge)
        more += sample.statistics[c].count - expected[s][c].count * sample.frames / frames[s];
    }
  }
  return shots > 0.0 ? std::max(0.0, more / shots) : 0.0;
}

/// Size of what is measured more or less, on the whole or beam by beam, whichever is larger. Of existence only the sign
/// that the component has: what may be noise stands in both.
double sizeOf(const ResidualTable& table) {
  double sum = 0.0, weight = 0.0;
  for (const Row& row : table.rows) {
    sum += row.weight * row.value;
    weight += row.weight;
  }
  if (weight == 0.0) return 0.0;
  const double sign = table.sign();
  const double size = sign != 0.0 ? std::max(0.0, sign * sum) : std::max(std::abs(sum), totalGapOf(table.rows));
  return size / weight / table.scale;
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
  result.false_echoes_per_shot = falseEchoesPerShot(replay, result.expected, frames);
  for (const ResidualTable& table : result.tables) {
    if (table.component == "missing") result.gate = gateIn(replay, table);
    result.largest_steps = std::max({result.largest_steps, table.excess(), table.commonShift()});
  }
  for (const WhereRow& row : result.rows) {
    for (const ResidualTable& table : result.tables) {
      if (table.measurand != row.measurand || table.component != row.component || row.mayBeChance()) continue;
      result.largest_steps = std::max(result.largest_steps, std::abs(row.value) / table.scale);
    }
  }
  return result;
}

std::vector<WhereRow> rowsOfCause(const Replay& replay, const WhereResult& without, const WhereResult& with) {
  const auto tables = residualTables(replay, {with.expected, with.frames, without.expected, without.frames});
  SizeOfTables changes;
  double most = 0.0;
  for (const ResidualTable& table : withMovedEchoes(replay, tables, with.expected, without.expected)) {
    const double size = sizeOf(table);
    changes[{table.measurand, table.component}] = size;
    most = std::max(most, size);
  }
  std::erase_if(changes, [&](const auto& change) { return change.second < kChanges * most || change.second == 0.0; });
  return whereRows(replay, without.by_beam, without.expected, changes);
}

}  // namespace gap
