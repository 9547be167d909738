#include "gap/where/gate.h"

#include <algorithm>
#include <vector>

namespace gap {

namespace {

/// A surface that a beam should see: echoes lost less echoes there, over the frames.
struct Expected {
  double range_m;
  double balance;
};

std::vector<Expected> expectedIn(const Replay& replay, const ResidualTable& missing) {
  std::vector<Expected> list;
  for (const ResidualTable::Row& row : missing.rows) {
    const ReplaySample& sample = replay.samples()[row.sample];
    const Cell& cell = sample.layout->cells()[row.cell];
    if (cell.object < 0) continue;
    const double lost = std::max(0.0, -row.value) * row.weight;
    list.push_back({cell.anchor_m, lost - sample.statistics[row.cell].count});
  }
  std::stable_sort(list.begin(), list.end(),
                   [](const Expected& a, const Expected& b) { return a.range_m < b.range_m; });
  return list;
}

/// Where the sum of the balances from the begin of the list on is largest, if it is positive anywhere.
template <typename Iterator>
std::optional<double> endOfLoss(Iterator begin, Iterator end) {
  double sum = 0.0, most = 0.0;
  std::optional<double> range_m;
  for (Iterator i = begin; i != end; ++i) {
    sum += i->balance;
    if (sum <= most) continue;
    most = sum;
    range_m = i + 1 == end ? i->range_m : 0.5 * (i->range_m + (i + 1)->range_m);
  }
  return range_m;
}

}  // namespace

Gate gateIn(const Replay& replay, const ResidualTable& missing) {
  const std::vector<Expected> expected = expectedIn(replay, missing);
  return {endOfLoss(expected.begin(), expected.end()), endOfLoss(expected.rbegin(), expected.rend())};
}

}  // namespace gap
