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
  double peak_m;
  double lost;   ///< over the frames
  double there;  ///< over the frames
};

using BeamOfSample = std::pair<std::size_t, std::uint32_t>;
using Beams = std::map<BeamOfSample, std::vector<ExpectedEcho>>;

/// From the range of an echo to its peak: in the middle of its width, which is c·Δt, not halved.
double toPeak_m(const model::SensorProfile& sensor, const CellStatistics& expected) {
  return sensor.detection.range_mode == model::RangeMode::kLeadingEdge ? expected.mean(kEpw) / 4.0 : 0.0;
}

/// The echoes of each beam, by range. What is expected of a beam itself (behind a pane) is taken for one place.
Beams expectedIn(const Replay& replay, const ResidualTable& missing, const CellsOfSamples& expected) {
  Beams beams;
  for (const ResidualTable::Row& row : missing.rows) {
    const CellStatistics& statistics = expected[row.sample][row.cell];
    if (statistics.count == 0.0) continue;
    const ReplaySample& sample = replay.samples()[row.sample];
    const Cell& cell = sample.layout->cells()[row.cell];
    const double range_m = cell.anchor_m + statistics.mean(kRange);
    const model::SensorProfile& sensor = replay.baseline().model.sensor(sample.sample->sensor);
    beams[{row.sample, cell.beam}].push_back({range_m, range_m + toPeak_m(sensor, statistics),
                                              std::max(0.0, -row.value) * row.weight,
                                              sample.statistics[row.cell].count});
  }
  for (auto& [beam, echoes] : beams) {
    std::stable_sort(echoes.begin(), echoes.end(),
                     [](const ExpectedEcho& a, const ExpectedEcho& b) { return a.range_m < b.range_m; });
  }
  return beams;
}

std::optional<double> within_m(const Beams& beams, double ExpectedEcho::*place) {
  std::vector<LossAt> pairs;  // lost in as many shots as one of the two is; both there in as many as the rarer one
  for (const auto& [beam, echoes] : beams) {
    for (std::size_t i = 0; i + 1 < echoes.size(); ++i) {
      const ExpectedEcho &near = echoes[i], &far = echoes[i + 1];
      pairs.push_back({far.*place - near.*place, std::max(near.lost, far.lost) - std::min(near.there, far.there)});
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(), [](const LossAt& a, const LossAt& b) { return a.value < b.value; });
  return endOfLoss(pairs);
}

}  // namespace

NearEchoes lossOfNearEchoes(const Replay& replay, const ResidualTable& missing, const CellsOfSamples& expected) {
  const Beams beams = expectedIn(replay, missing, expected);
  return {.within_m = within_m(beams, &ExpectedEcho::range_m),
          .peaks_within_m = within_m(beams, &ExpectedEcho::peak_m)};
}

}  // namespace gap
