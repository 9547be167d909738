#include "gap/where/strata.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "gap/replay/statistics.h"
#include "gap/where/covariates.h"

namespace gap {

namespace {

constexpr std::size_t kQuantileGroups = 16;
constexpr std::size_t kFewGroups = 2;    // a run of so few is cut once more
constexpr double kSmallestExcess = 0.1;  // of the resolution: less is not worth a row
constexpr double kSomewhere = 0.05;      // lift: what a cause changes less unevenly it changes everywhere alike

using Row = ResidualTable::Row;

/// The gap of a table, and what a row adds to it: what its noise does not explain; or, where echoes are so few that no
/// single cell shows them, what it counts, with its sign, so that noise averages out. The table outlives it.
class GapOfRows {
 public:
  explicit GapOfRows(const ResidualTable& table) : table_(table), all_(table.sumBeyondErrors()), data_(table.weight()) {
    if (all_ > 0.0) return;
    count_sign_ = table.sign();
    for (const Row& row : table.rows) all_ += of(row);
  }
  [[nodiscard]] const ResidualTable& table() const { return table_; }
  [[nodiscard]] double of(const Row& row) const {
    return row.weight * (count_sign_ == 0.0 ? row.beyondError() : count_sign_ * row.value);
  }
  [[nodiscard]] double all() const { return all_; }
  [[nodiscard]] double data() const { return data_; }  ///< detections, or shots

 private:
  const ResidualTable& table_;
  double count_sign_ = 0.0;
  double all_;
  double data_;
};

/// A group of rows with adjacent values (or one name).
struct Group {
  double low = 0.0, high = 0.0;
  std::string name;
  double gap = 0.0, weight = 0.0, value = 0.0, variance = 0.0, noise = 0.0;  // sums

  void add(const Row& row, const GapOfRows& gaps) {
    gap += gaps.of(row);
    weight += row.weight;
    value += row.weight * row.value;
    variance += row.weight * row.weight * row.error * row.error;
    noise += row.weight * gaps.table().meanOfNoise(row);
  }
  void add(const Group& other) {
    gap += other.gap;
    weight += other.weight;
    value += other.value;
    variance += other.variance;
    noise += other.noise;
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

/// A run of groups that holds more of a gap than of the data.
struct Best {
  Group joint;
  std::size_t first = 0, last = 0;
  double lift = -1.0;
  std::size_t tried = 0;
};

/// The run of groups whose share of the gap exceeds its share of the data most; of names only such that deviate the
/// same way, for what one is too long and another too short has no size. Its mean residual has the sign of the table,
/// if that has one. `weight`: of all data that might be in it.
Best bestRun(const std::vector<Group>& groups, const GapOfRows& gaps, double weight, bool prefixes_only) {
  const double sign = gaps.table().sign();
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
      const double lift = joint.gap / gaps.all() - joint.weight / weight;
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
Best narrowed(Best best, const Covariate& covariate, const GapOfRows& gaps, double weight) {
  std::vector<Row> inside;
  for (const Row& row : gaps.table().rows) {
    const double x = covariate.number(row);
    if (x >= best.joint.low && x <= best.joint.high) inside.push_back(row);
  }
  const std::vector<Group> groups = numericGroups(inside, covariate, gaps);
  if (groups.size() < 2) return best;
  Best part = bestRun(groups, gaps, weight, false);
  const std::size_t tried = best.tried + part.tried;
  if (part.lift > best.lift) best = std::move(part);
  best.tried = tried;
  return best;
}

/// Of one covariate: an interval or names.
struct Stratum {
  double low = 0.0, high = 0.0;
  std::vector<std::string> names;  // in order
  double lift = 0.0;
  std::size_t tried = 0;

  [[nodiscard]] bool holds(const Row& row, const Covariate& covariate) const {
    if (!covariate.numeric) return std::binary_search(names.begin(), names.end(), covariate.text(row));
    const double x = covariate.number(row);
    return x >= low && x <= high;
  }
};

/// That which exceeds its share of the data most, if any does.
std::optional<Stratum> stratumOf(const GapOfRows& gaps, const Covariate& covariate) {
  if (gaps.all() <= 0.0) return std::nullopt;
  const std::vector<Row>& rows = gaps.table().rows;
  const auto groups = covariate.numeric ? numericGroups(rows, covariate, gaps) : namedGroups(rows, covariate, gaps);
  if (groups.size() < 2) return std::nullopt;
  // Where nothing is there is no range, and no shot more: every beam has its place behind the last surface.
  double weight = 0.0;
  for (const Group& group : groups) weight += group.weight;
  if (gaps.table().sign() == 0.0) weight = gaps.data();
  Best best = bestRun(groups, gaps, weight, !covariate.numeric);
  if (best.lift <= 0.0) return std::nullopt;
  if (covariate.numeric && best.last - best.first < kFewGroups)
    best = narrowed(std::move(best), covariate, gaps, weight);
  Stratum stratum{best.joint.low, best.joint.high, {}, best.lift, best.tried};
  if (!covariate.numeric) {
    for (std::size_t g = best.first; g <= best.last; ++g) stratum.names.push_back(groups[g].name);
    std::sort(stratum.names.begin(), stratum.names.end());
  }
  return stratum;
}

const TableChange* changeOf(const std::vector<TableChange>& changes, const ResidualTable& table) {
  const auto found = std::find_if(changes.begin(), changes.end(), [&](const TableChange& change) {
    return change.table.isOf(table.measurand, table.component);
  });
  return found == changes.end() ? nullptr : &*found;
}

/// Covariates that a person thinks in first; they win where two tell the same story.
double readability(const std::string& covariate) {
  if (covariate == "time_s" || covariate == "setup" || covariate == "epw_m" || covariate == "intensity") return 0.85;
  if (covariate == "elevation_deg" || covariate == "material") return 0.95;
  return 1.0;
}

/// What a stratum holds of a table; its p-value is that of one stratum.
WhereRow rowOf(const GapOfRows& gaps, const Covariate& covariate, const Stratum& stratum) {
  const ResidualTable& table = gaps.table();
  Group joint;
  std::vector<const Row*> held;
  for (const Row& row : table.rows) {
    if (!stratum.holds(row, covariate)) continue;
    joint.add(row, gaps);
    held.push_back(&row);
  }
  const double weight = table.weightOf(held);
  WhereRow row;
  row.measurand = table.measurand;
  row.component = table.component;
  row.covariate = covariate.name;
  row.numeric = covariate.numeric;
  row.low = stratum.low;
  row.high = stratum.high;
  row.names = stratum.names;
  row.value = weight > 0.0 ? joint.value / weight : 0.0;
  row.unit = table.unit;
  row.share = std::clamp(joint.gap / gaps.all(), 0.0, 1.0);
  row.size = weight / gaps.data();
  const double beyond_noise = std::max(0.0, std::abs(joint.value) - joint.noise);
  row.p_value = 2.0 * upperTail(beyond_noise / std::sqrt(std::max(1e-300, joint.variance)));
  row.score = stratum.lift * readability(covariate.name);
  return row;
}

/// The rows of a table, best first, with what puts the table before others.
struct Ranked {
  double changed = 0.0;  ///< what a cause changes in the table
  double gap = 0.0;      ///< of the table, if it may not be chance
  std::vector<WhereRow> rows;

  [[nodiscard]] bool before(const Ranked& other) const {
    if (changed != other.changed) return changed > other.changed;
    if (gap != other.gap) return gap > other.gap;
    return rows.front().score > other.rows.front().score;
  }
};

/// Of every covariate the best stratum; p-values are corrected for so many tables. No rows where nothing is to be told.
Ranked rankedRows(const ResidualTable& table, const TableChange* change, const std::vector<Covariate>& covariates,
                  std::size_t tables) {
  const GapOfRows gaps(table);
  const double size = std::max(table.excess(), table.commonShift());
  Ranked ranked{change ? change->size : 0.0, 0.0, {}};
  if (gaps.all() <= 0.0 || (size < kSmallestExcess && !change)) return ranked;
  const std::optional<GapOfRows> changed = change ? std::optional<GapOfRows>(change->table) : std::nullopt;
  for (const Covariate& covariate : covariates) {
    std::optional<Stratum> stratum = changed ? stratumOf(*changed, covariate) : std::nullopt;
    if (!stratum || stratum->lift < kSomewhere) stratum = stratumOf(gaps, covariate);
    if (!stratum) continue;
    WhereRow row = rowOf(gaps, covariate, *stratum);
    if (row.size <= 0.0) continue;  // a cause may act where one of both sides has nothing to compare
    row.p_value = std::min(1.0, row.p_value * static_cast<double>(stratum->tried * covariates.size() * tables));
    if (!row.mayBeChance()) ranked.gap = size;
    ranked.rows.push_back(std::move(row));
  }
  // Of places that all shots have, as the void behind the last surface, none is a part of the shots.
  const auto isNoPart = [&](const WhereRow& row) { return table.sign() != 0.0 && row.share <= row.size; };
  if (!std::all_of(ranked.rows.begin(), ranked.rows.end(), isNoPart)) std::erase_if(ranked.rows, isNoPart);
  std::stable_sort(ranked.rows.begin(), ranked.rows.end(), [](const WhereRow& a, const WhereRow& b) {
    return a.mayBeChance() != b.mayBeChance() ? b.mayBeChance() : a.score > b.score;
  });
  return ranked;
}

}  // namespace

std::vector<WhereRow> whereRows(const Replay& replay, const std::vector<ResidualTable>& tables,
                                const CellsOfSamples& expected, const std::vector<TableChange>& changes) {
  const std::vector<Covariate> covariates = covariatesOf(replay, expected);
  std::vector<Ranked> ranked;
  for (const ResidualTable& table : tables) {
    ranked.push_back(rankedRows(table, changeOf(changes, table), covariates, tables.size()));
    if (ranked.back().rows.empty()) ranked.pop_back();
  }
  std::stable_sort(ranked.begin(), ranked.end(), [](const Ranked& a, const Ranked& b) { return a.before(b); });
  std::vector<WhereRow> result;
  for (Ranked& table : ranked)
    result.insert(result.end(), std::make_move_iterator(table.rows.begin()), std::make_move_iterator(table.rows.end()));
  return result;
}

}  // namespace gap
