#include "gap/where/where.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "gap/distance/discrepancy.h"
#include "gap/distance/settle.h"
#include "gap/replay/statistics.h"
#include "gap/where/covariates.h"
#include "gap/where/gate.h"
#include "gap/where/sectors.h"

namespace gap {

namespace {

constexpr std::size_t kQuantileGroups = 16;
constexpr double kSmallestExcess = 0.1;  // of the resolution: less is not worth a row
constexpr int kWhereFrames = 24;
constexpr std::uint64_t kOtherNoise = 5000;  // added to the seed
constexpr double kMayBeNoise = 2.0;          // standard errors
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

/// A group of rows with adjacent values (or one name).
struct Group {
  double low = 0.0, high = 0.0;
  std::string name;
  double gap = 0.0, weight = 0.0, value = 0.0, variance = 0.0;  // sums

  void add(const Row& row) {
    gap += row.weight * beyondError(row);
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

std::vector<Group> numericGroups(const std::vector<Row>& rows, const Covariate& covariate) {
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
    groups.back().add(*row);
    passed += row->weight;
  }
  return groups;
}

std::vector<Group> namedGroups(const std::vector<Row>& rows, const Covariate& covariate) {
  std::map<std::string, Group> by_name;
  for (const Row& row : rows) {
    Group& group = by_name[covariate.text(row)];
    group.add(row);
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

/// The run of groups whose share of the gap exceeds its share of the data most.
Best bestRun(const std::vector<Group>& groups, double all_gap, double all_weight, bool prefixes_only) {
  Best best;
  for (std::size_t first = 0; first < (prefixes_only ? 1 : groups.size()); ++first) {
    Group joint;
    for (std::size_t last = first; last < groups.size(); ++last) {
      joint.add(groups[last]);
      if (last - first + 1 == groups.size()) break;  // everything is no stratum
      ++best.tried;
      const double lift = joint.gap / all_gap - joint.weight / all_weight;
      if (lift > best.lift + 1e-12) {
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

double ResidualTable::commonShift() const {
  double sum = 0.0, weight = 0.0, variance = 0.0;
  for (const Row& row : rows) {
    sum += row.weight * row.value;
    weight += row.weight;
    variance += row.weight * row.weight * row.error * row.error;
  }
  if ((component == "missing" && sum > 0.0) || (component == "extra" && sum < 0.0)) return 0.0;
  return weight > 0.0 && std::abs(sum) > 5.0 * std::sqrt(variance) ? std::abs(sum) / weight / scale : 0.0;
}

std::vector<ResidualTable> residualTables(const Replay& replay,
                                          const std::vector<std::vector<CellStatistics>>& simulated,
                                          const std::vector<int>& simulated_frames) {
  std::vector<ResidualTable> tables;
  for (const Channel channel : replay.channels()) {
    const model::Measurand* measurand = nullptr;
    for (const model::Measurand& m : replay.experiment().measurands) {
      if (m.name == nameOf(channel) || m.column == columnOf(channel)) measurand = &m;
    }
    ResidualTable bias{measurand->name, "bias", measurand->unit, measurand->resolution, {}};
    ResidualTable scatter{measurand->name, "scatter", measurand->unit, measurand->resolution, {}};
    for (std::size_t s = 0; s < replay.samples().size(); ++s) {
      for (std::size_t c = 0; c < replay.samples()[s].layout->surfaces(); ++c) {
        const CellStatistics &m = replay.samples()[s].statistics[c], &x = simulated[s][c];
        if (m.count == 0.0 || x.count == 0.0) continue;
        bias.rows.push_back({s, c, m.mean(channel) - x.mean(channel),
                             meanError(replay, replay.samples()[s], c, channel, m, x), m.count});
        if (m.count < 5.0 || x.count < 5.0) continue;
        const double sm = std::sqrt(m.variance(channel)), sx = std::sqrt(x.variance(channel));
        const double error =
            std::sqrt(m.variance(channel) / (2.0 * (m.count - 1.0)) + x.variance(channel) / (2.0 * (x.count - 1.0)) +
                      std::pow(0.1 * measurand->resolution, 2.0));
        scatter.rows.push_back({s, c, sm - sx, error, m.count});
      }
    }
    tables.push_back(std::move(bias));
    tables.push_back(std::move(scatter));
  }
  ResidualTable missing{"existence", "missing", "1/shot", kExistenceScale, {}};
  ResidualTable extra{"existence", "extra", "1/shot", kExistenceScale, {}};
  double echoes = 0.0;
  for (std::size_t s = 0; s < replay.samples().size(); ++s) {
    const ReplaySample& sample = replay.samples()[s];
    if (sample.layout->pooled()) continue;
    for (std::size_t c = 0; c < sample.layout->cells().size(); ++c) {
      const double measured = sample.statistics[c].count / sample.frames;
      const double expected = simulated[s][c].count / simulated_frames[s];
      const double rate = std::clamp(0.5 * (measured + expected), 0.01, 0.99);
      const double error = std::sqrt(rate * (1.0 - rate) * (1.0 / sample.frames + 1.0 / simulated_frames[s]) + 1e-4);
      const double value = measured - expected;
      echoes += expected * sample.frames;
      // What may be noise stays in both with its sign, so that it averages out: a half of it would look like a loss.
      const bool noise = std::abs(value) < kMayBeNoise * error;
      missing.rows.push_back({s, c, noise ? value : std::min(0.0, value), error, static_cast<double>(sample.frames)});
      extra.rows.push_back({s, c, noise ? value : std::max(0.0, value), error, static_cast<double>(sample.frames)});
    }
  }
  double shots = 0.0;
  for (const Row& row : missing.rows) shots += row.weight;
  if (shots > 0.0 && echoes > 0.0) missing.scale = extra.scale = kExistenceScale * echoes / shots;
  if (!missing.rows.empty()) tables.push_back(std::move(missing));
  if (!extra.rows.empty()) tables.push_back(std::move(extra));
  return tables;
}

std::vector<WhereRow> whereRows(const Replay& replay, const std::vector<ResidualTable>& tables,
                                const std::vector<std::vector<CellStatistics>>& expected) {
  const std::vector<Covariate> covariates = covariatesOf(replay, expected);
  std::vector<WhereRow> result;
  for (const ResidualTable& table : tables) {
    const double all_gap = totalGapOf(table.rows);
    if (all_gap <= 0.0 || std::max(table.excess(), table.commonShift()) < kSmallestExcess) continue;
    double all_weight = 0.0;
    for (const Row& row : table.rows) all_weight += row.weight;
    for (const Covariate& covariate : covariates) {
      const auto groups = covariate.numeric ? numericGroups(table.rows, covariate) : namedGroups(table.rows, covariate);
      if (groups.size() < 2) continue;
      const Best best = bestRun(groups, all_gap, all_weight, !covariate.numeric);
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
      row.share = best.joint.gap / all_gap;
      row.size = best.joint.weight / all_weight;
      const double z = std::abs(best.joint.value) / std::sqrt(std::max(1e-300, best.joint.variance));
      row.p_value =
          std::min(1.0, 2.0 * upperTail(z) * static_cast<double>(best.tried * covariates.size() * tables.size()));
      row.score = best.lift * readability(covariate.name);
      result.push_back(std::move(row));
    }
  }
  // The measurand with the largest gap first; within it the stratum that concentrates it most, what may be noise last.
  std::map<std::pair<std::string, std::string>, double> largest;
  for (const ResidualTable& table : tables) {
    const bool significant = std::any_of(result.begin(), result.end(), [&](const WhereRow& row) {
      return row.measurand == table.measurand && row.component == table.component && !row.mayBeChance();
    });
    largest[{table.measurand, table.component}] = significant ? std::max(table.excess(), table.commonShift()) : 0.0;
  }
  std::stable_sort(result.begin(), result.end(), [&](const WhereRow& a, const WhereRow& b) {
    const double excess_a = largest[{a.measurand, a.component}], excess_b = largest[{b.measurand, b.component}];
    const bool sure_a = !a.mayBeChance(), sure_b = !b.mayBeChance();
    if (excess_a != excess_b) return excess_a > excess_b;
    return sure_a != sure_b ? sure_a : a.score > b.score;
  });
  return result;
}

WhereResult whereIn(const Replay& replay, const World& world, std::uint64_t seed) {
  std::vector<std::vector<CellStatistics>> simulated(replay.samples().size()), expected(replay.samples().size());
  std::vector<int> frames(replay.samples().size());
  std::vector<Comparison> comparisons;
  for (std::size_t s = 0; s < replay.samples().size(); ++s) {
    const ReplaySample& sample = replay.samples()[s];
    frames[s] = std::clamp(sample.frames, 3, kWhereFrames);
    comparisons.push_back({s, sample.statistics, sample.frames, replay.simulate(world, s, frames[s], seed), frames[s]});
  }
  settle(replay, world, comparisons, {});
  for (std::size_t s = 0; s < simulated.size(); ++s) {
    simulated[s] = std::move(comparisons[s].simulated);
    expected[s] = replay.simulate(world, s, frames[s], seed + kOtherNoise);
  }
  WhereResult result;
  result.tables = residualTables(replay, simulated, frames);
  result.rows = whereRows(replay, result.tables, expected);
  result.sectors = sectorsIn(replay, result.tables);
  for (const ResidualTable& table : result.tables) {
    if (table.component == "missing") result.gate = gateIn(replay, table);
  }
  result.expected = std::move(expected);
  for (const ResidualTable& table : result.tables) {
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

}  // namespace gap
