#include "gap/where/gate.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "gap/replay/statistics.h"
#include "gap/where/end_of_loss.h"

namespace gap {

namespace {

/// By range, every surface that a beam should see, over the frames.
std::vector<LossAt> expectedIn(const Replay& replay, const ResidualTable& missing) {
  std::vector<LossAt> list;
  for (const ResidualTable::Row& row : missing.rows) {
    const ReplaySample& sample = replay.samples()[row.sample];
    const Cell& cell = sample.layout->cells()[row.cell];
    if (cell.object < 0) continue;
    const double lost = std::max(0.0, -row.value) * row.weight;
    list.push_back({cell.anchor_m, lost - sample.statistics[row.cell].count});
  }
  std::stable_sort(list.begin(), list.end(), [](const LossAt& a, const LossAt& b) { return a.value < b.value; });
  return list;
}

/// Of a range of one cell about its mean: the variance of a few frames of one cell would have tails.
double varianceWithin(const std::vector<CellStatistics>& cells) {
  double squares = 0.0, degrees = 0.0;
  for (const CellStatistics& cell : cells) {
    if (cell.count < 2.0) continue;
    squares += cell.variance(kRange) * (cell.count - 1.0);
    degrees += cell.count - 1.0;
  }
  return degrees > 0.0 ? squares / degrees : 0.0;
}

/// Echoes, or numbers of them, to both sides.
struct Ends {
  double nearest = 0.0;
  double farthest = 0.0;
};

/// The outermost measured ranges; nothing if nothing was measured.
std::optional<Ends> outermostIn(const Replay& replay) {
  std::optional<Ends> ends;
  for (const ReplaySample& sample : replay.samples()) {
    for (const double range_m : sample.measured.range_m)
      ends = ends ? Ends{std::min(ends->nearest, range_m), std::max(ends->farthest, range_m)} : Ends{range_m, range_m};
  }
  return ends;
}

/// How many echoes of surfaces the baseline makes beyond these ranges, in as many frames as were measured.
Ends expectedBeyond(const Replay& replay, const Ends& ends_m) {
  constexpr int kFrames = 16;  // enough for a mean
  const double of_step = replay.resolution(kRange) * replay.resolution(kRange) / 12.0;
  Ends sum;
  for (std::size_t s = 0; s < replay.samples().size(); ++s) {
    const ReplaySample& sample = replay.samples()[s];
    std::vector<CellStatistics> cells = replay.simulate(replay.baseline(), s, kFrames, replay.seed());
    cells.resize(sample.layout->surfaces());
    const double stddev = std::sqrt(std::max(of_step, varianceWithin(cells)));
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (cells[c].count == 0.0) continue;
      const double mean_m = sample.layout->cells()[c].anchor_m + cells[c].mean(kRange);
      const double echoes = cells[c].count / kFrames * sample.frames;
      sum.nearest += echoes * upperTail((mean_m - ends_m.nearest) / stddev);
      sum.farthest += echoes * upperTail((ends_m.farthest - mean_m) / stddev);
    }
  }
  return sum;
}

}  // namespace

Gate gateIn(const Replay& replay, const ResidualTable& missing) {
  constexpr double kSeveral = 5.0;  // by chance none of them in 1 of 150
  const std::vector<LossAt> expected = expectedIn(replay, missing);
  Gate gate{endOfLoss(expected), endOfLoss({expected.rbegin(), expected.rend()}), {}, {}};
  if (const std::optional<Ends> ends_m = outermostIn(replay)) {
    const Ends beyond = expectedBeyond(replay, *ends_m);
    if (beyond.nearest > kSeveral) gate.nearest_m = ends_m->nearest;
    if (beyond.farthest > kSeveral) gate.farthest_m = ends_m->farthest;
  }
  return gate;
}

}  // namespace gap
