#include "gap/which/frame_mode.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace gap {

namespace {

/// By channel.
constexpr std::vector<double> core::Detections::*kValues[] = {&core::Detections::range_m, &core::Detections::epw_m,
                                                              &core::Detections::intensity};

constexpr double kRounding = 1e-3;  // of the resolution: values that scatter less are one, and rounding
constexpr double kStandsOut = 6.0;  // standard deviations: a right model of any kind gives three at most

/// Deviation of every frame from the others: mean over its detections of what each deviates from its cell's mean.
struct Deviations {
  std::map<std::int32_t, double> deviation;
  double excess = 0.0;    ///< of the squares of the frames' deviations over what independent detections give, which
  double expected = 0.0;  ///< has this mean: the number of frames but one
  double variance = 0.0;  ///< of the common deviation
};

Deviations deviationsOf(const ReplaySample& sample, const core::Detections& detections,
                        const std::vector<std::uint32_t>& beam_of, const std::vector<double>& values,
                        double resolution) {
  struct Sums {
    double count = 0.0, sum = 0.0;
  };
  const std::vector<std::size_t> cells = sample.layout->cellsOf(detections, beam_of);
  std::vector<Sums> of_cell(sample.layout->cells().size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    of_cell[cells[i]].count += 1.0;
    of_cell[cells[i]].sum += values[i];
  }
  std::map<std::int32_t, Sums> of_frame;
  double squares = 0.0, freedom = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Sums& cell = of_cell[cells[i]];
    if (cells[i] >= sample.layout->surfaces() || cell.count < 2.0) continue;
    const double deviation = values[i] - cell.sum / cell.count;
    of_frame[detections.frame[i]].count += 1.0;
    of_frame[detections.frame[i]].sum += deviation;
    squares += deviation * deviation;
    freedom += 1.0 - 1.0 / cell.count;
  }
  Deviations frames;
  if (of_frame.size() < 2 || freedom <= 0.0) return frames;
  const double variance = squares / freedom;  // of one detection
  if (variance < std::pow(kRounding * resolution, 2.0)) return frames;
  frames.expected = static_cast<double>(of_frame.size()) - 1.0;
  frames.excess = -frames.expected;
  for (const auto& [frame, sums] : of_frame) {
    const double mean = sums.sum / sums.count;
    frames.deviation[frame] = mean;
    frames.excess += sums.count * mean * mean / variance;
    frames.variance += std::max(0.0, mean * mean - variance / sums.count) / frames.expected;
  }
  return frames;
}

/// All samples in one channel: nothing is fitted to them here, so those that are held out tell no more than others.
struct Seen {
  std::vector<Deviations> measured;  ///< by sample
  double z = 0.0;
  double stddev = 0.0;
};

double zOf(const std::vector<Deviations>& samples) {
  double excess = 0.0, expected = 0.0;
  for (const Deviations& frames : samples) {
    excess += frames.excess;
    expected += frames.expected;
  }
  return expected > 0.0 ? excess / std::sqrt(2.0 * expected) : 0.0;  // of a chi-squared distribution
}

Seen seenIn(const Replay& replay, Channel channel) {
  Seen seen;
  for (const ReplaySample& sample : replay.samples()) {
    seen.measured.push_back(deviationsOf(sample, sample.measured, sample.beam_of, sample.measured.*kValues[channel],
                                         replay.resolution(channel)));
    seen.stddev += seen.measured.back().variance / static_cast<double>(replay.samples().size());
  }
  seen.stddev = std::sqrt(seen.stddev);
  seen.z = zOf(seen.measured);
  return seen;
}

/// Whether the frames of the baseline deviate, too.
bool isOfTheBaseline(const Replay& replay, Channel channel) {
  std::vector<Deviations> simulated;
  for (std::size_t s = 0; s < replay.samples().size(); ++s) {
    const ReplaySample& sample = replay.samples()[s];
    const core::Detections baseline = replay.detections(replay.baseline(), s, replay.seed());
    const auto beam_of = beamsOfDetections(baseline, sample.beams, {});
    simulated.push_back(
        deviationsOf(sample, baseline, beam_of, baseline.*kValues[channel], replay.resolution(channel)));
  }
  return zOf(simulated) >= kStandsOut;
}

/// Discrepancy of the baseline to a measurement from which the common deviation of every frame was taken out.
double discrepancyWithout(const Judge& judge, const Seen& seen, Channel channel) {
  const Replay& replay = judge.replay;
  const Evidence& held_out = judge.split.held_out;
  std::vector<std::vector<CellStatistics>> corrected;
  for (const std::size_t s : held_out.samples) {
    const ReplaySample& sample = replay.samples()[s];
    core::Detections measured = sample.measured;
    std::vector<double>& values = measured.*kValues[channel];
    for (std::size_t d = 0; d < values.size(); ++d) {
      const auto deviation = seen.measured[s].deviation.find(measured.frame[d]);
      if (deviation != seen.measured[s].deviation.end()) values[d] -= deviation->second;
    }
    corrected.push_back(sample.layout->statisticsOf(measured, sample.beam_of));
  }
  return discrepancyTo(replay, replay.baseline(), held_out, corrected);
}

}  // namespace

std::optional<FrameMode> frameModeOf(const Judge& judge) {
  const Replay& replay = judge.replay;
  if (replay.samples().front().layout->pooled()) return std::nullopt;
  FrameMode mode;
  Seen most;
  for (const Channel channel : replay.channels()) {
    Seen seen = seenIn(replay, channel);
    if (seen.z < kStandsOut || seen.z <= mode.z || isOfTheBaseline(replay, channel)) continue;
    mode.channel = channel;
    mode.z = seen.z;
    mode.stddev = seen.stddev;
    most = std::move(seen);
  }
  if (mode.z < kStandsOut) return std::nullopt;
  const double without = discrepancyWithout(judge, most, mode.channel);
  mode.share_of_gap = (judge.yardstick.baseline - without) / judge.yardstick.whole();
  return mode;
}

}  // namespace gap
