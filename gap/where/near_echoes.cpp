#include "gap/where/near_echoes.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "gap/where/end_of_loss.h"

namespace gap {

namespace {

/// Echoes that are expected at one place of a beam.
struct ExpectedEcho {
  double range_m;
  double lost;   ///< over the frames
  double there;  ///< over the frames
};

using BeamOfSample = std::pair<std::size_t, std::uint32_t>;

/// The echoes of each beam, by range. What is expected of a beam itself (behind a pane) is taken for one place.
std::map<BeamOfSample, std::vector<ExpectedEcho>> expectedIn(const Replay& replay, const ResidualTable& missing,
                                                             const CellsOfSamples& expected) {
  std::map<BeamOfSample, std::vector<ExpectedEcho>> beams;
  for (const ResidualTable::Row& row : missing.rows) {
    const CellStatistics& statistics = expected[row.sample][row.cell];
    if (statistics.count == 0.0) continue;
    const ReplaySample& sample = replay.samples()[row.sample];
    const Cell& cell = sample.layout->cells()[row.cell];
    beams[{row.sample, cell.beam}].push_back({cell.anchor_m + statistics.mean(kRange),
                                              std::max(0.0, -row.value) * row.weight,
                                              sample.statistics[row.cell].count});
  }
  for (auto& [beam, echoes] : beams) {
    std::stable_sort(echoes.begin(), echoes.end(),
                     [](const ExpectedEcho& a, const ExpectedEcho& b) { return a.range_m < b.range_m; });
  }
  return beams;
}

}  // namespace

std::optional<double> lossOfNearEchoes_m(const Replay& replay, const ResidualTable& missing,
                                         const CellsOfSamples& expected) {
  std::vector<LossAt> pairs;  // lost in as many shots as one of the two is; both there in as many as the rarer one
  for (const auto& [beam, echoes] : expectedIn(replay, missing, expected)) {
    for (std::size_t i = 0; i + 1 < echoes.size(); ++i) {
      const ExpectedEcho &near = echoes[i], &far = echoes[i + 1];
      pairs.push_back({far.range_m - near.range_m, std::max(near.lost, far.lost) - std::min(near.there, far.there)});
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(), [](const LossAt& a, const LossAt& b) { return a.value < b.value; });
  return endOfLoss(pairs);
}

}  // namespace gap
