#include "gap/where/strata.h"

#include <algorithm>
#include <cmath>

#include "gap/replay/statistics.h"
#include "gap/where/covariates.h"

namespace gap {

namespace {

constexpr std::size_t kQuantileGroups = 16;
constexpr std::size_t kFewGroups = 2;    // a run of so few is cut once more
constexpr double kSmallestExcess = 0.1;  // of the resolution: less is not worth a row

using Row = ResidualTable::Row;

/// What a row adds to the gap of its table: what its noise does not explain; or, where echoes are so few that no single
/// cell shows them, what it counts, with its sign, so that noise averages out.
class GapOfRows {
 public:
  explicit GapOfRows(const ResidualTable& table) : all_(table.sumBeyondErrors()) {
    if (all_ > 0.0) return;
    sign_ = table.sign();
    for (const Row& row : table.rows) all_ += of(row);
  }
  [[nodiscard]] double of(const Row& row) const {
    return row.weight * (sign_ == 0.0 ? row.beyondError() : sign_ * row.value);
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
  // Worst first, those that deviate the other way last: a set of names is then a prefix.
  std::stable_sort(groups.begin(), groups.end(),
                   [](const Group& a, const Group& b) { return a.gap * b.weight > b.gap * a.weight; });
  std::stable_partition(
      groups.begin(), groups.end(),
      [worst = groups.empty() ? 0.0 : groups.front().value](const Group& group) { return group.value * worst >= 0.0; });
  return groups;
}

struct Best {
  Group joint;
  std::size_t first = 0, last = 0;
  double lift = -1.0;
  std::size_t tried = 0;
};

/// The run of groups whose share of the gap exceeds its share of the data most; of names only such that deviate the
/// same way, for what one is too long and another too short has no size. `sign`: of its mean residual; 0: any.
Best bestRun(const std::vector<Group>& groups, double all_gap, double all_weight, bool prefixes_only, double sign) {
  Best best;
  for (std::size_t first = 0; first < (prefixes_only ? 1 : groups.size()); ++first) {
    Group joint;
    joint.low = groups[first].low;
    for (std::size_t last = first; last < groups.size(); ++last) {
      if (prefixes_only && groups[last].value * groups[first].value < 0.0) break;
      joint.add(groups[last]);
      joint.high = groups[last].high;
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

/// What a run of a few groups holds may lie in a part of them, as a false target in two beams does: the run is cut once
/// more, as all data were.
Best narrowed(Best best, const std::vector<Row>& rows, const Covariate& covariate, const GapOfRows& gaps,
              double all_weight, double sign) {
  std::vector<Row> inside;
  for (const Row& row : rows) {
    const double x = covariate.number(row);
    if (x >= best.joint.low && x <= best.joint.high) inside.push_back(row);
  }
  const std::vector<Group> groups = numericGroups(inside, covariate, gaps);
  if (groups.size() < 2) return best;
  Best part = bestRun(groups, gaps.all(), all_weight, false, sign);
  const std::size_t tried = best.tried + part.tried;
  if (part.lift > best.lift) best = std::move(part);
  best.tried = tried;
  return best;
}

/// Covariates that a person thinks in first; they win where two tell the same story.
double readability(const std::string& covariate) {
  if (covariate == "time_s" || covariate == "setup" || covariate == "epw_m" || covariate == "intensity") return 0.85;
  if (covariate == "elevation_deg" || covariate == "material") return 0.95;
  return 1.0;
}

}  // namespace

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
      Best best = bestRun(groups, all_gap, all_weight, !covariate.numeric, table.sign());
      if (best.lift <= 0.0) continue;
      if (covariate.numeric && best.last - best.first < kFewGroups)
        best = narrowed(std::move(best), table.rows, covariate, gaps, all_weight, table.sign());
      WhereRow row;
      row.measurand = table.measurand;
      row.component = table.component;
      row.covariate = covariate.name;
      row.numeric = covariate.numeric;
      row.low = best.joint.low;
      row.high = best.joint.high;
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

}  // namespace gap
