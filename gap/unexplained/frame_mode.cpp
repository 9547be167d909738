#include "gap/unexplained/frame_mode.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace gap {

namespace {

/// By channel.
constexpr std::vector<double> core::Detections::*kValues[] = {&core::Detections::range_m, &core::Detections::epw_m,
                                                              &core::Detections::intensity};

constexpr double kRounding = 1e-3;  // of the resolution: values that scatter less are one, and rounding
constexpr double kGoodPart = 0.25;  // of what a cause moves
constexpr double kStandsOut = 6.0;  // standard deviations: a right model of any kind gives three at most

/// Deviation of every frame from the others: mean over its detections of what each deviates from its cell's mean.
struct FrameDeviations {
  std::map<std::int32_t, double> deviation;
  std::map<std::int32_t, double> weight;  ///< of each: one over its square error
  double excess = 0.0;    ///< of the squares of the frames' deviations over what independent detections give, which
  double expected = 0.0;  ///< has this mean: the number of frames but one
  double variance = 0.0;  ///< of the common deviation
};

FrameDeviations deviationsOf(const ReplaySample& sample, const core::Detections& detections,
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
  FrameDeviations frames;
  if (of_frame.size() < 2 || freedom <= 0.0) return frames;
  const double variance = squares / freedom;  // of one detection
  if (variance < std::pow(kRounding * resolution, 2.0)) return frames;
  frames.expected = static_cast<double>(of_frame.size()) - 1.0;
  frames.excess = -frames.expected;
  for (const auto& [frame, sums] : of_frame) {
    const double mean = sums.sum / sums.count;
    frames.deviation[frame] = mean;
    frames.weight[frame] = sums.count / variance;
    frames.excess += sums.count * mean * mean / variance;
    frames.variance += std::max(0.0, mean * mean - variance / sums.count) / frames.expected;
  }
  return frames;
}

/// Frames of one number, all samples together.
struct Alike {
  double z = 0.0;
  double span = 0.0;  ///< from the least to the largest deviation
};

Alike alikeIn(const std::vector<FrameDeviations>& samples) {
  std::map<std::int32_t, std::pair<double, double>> sums;  // of the weights, and of the weighted deviations
  for (const FrameDeviations& frames : samples) {
    for (const auto& [frame, deviation] : frames.deviation) {
      const double weight = frames.weight.at(frame);
      sums[frame].first += weight;
      sums[frame].second += weight * deviation;
    }
  }
  Alike alike;
  if (sums.size() < 2) return alike;
  const double expected = static_cast<double>(sums.size()) - 1.0;
  double squares = 0.0, least = 0.0, largest = 0.0;
  for (const auto& [frame, sum] : sums) {
    const double deviation = sum.second / sum.first;
    squares += sum.second * deviation;
    least = std::min(least, deviation);
    largest = std::max(largest, deviation);
  }
  alike.span = largest - least;
  alike.z = (squares - expected) / std::sqrt(2.0 * expected);
  return alike;
}

/// All samples in one channel: nothing is fitted to them here, so those that are held out tell no more than others.
struct Seen {
  std::vector<FrameDeviations> measured;  ///< by sample
  double z = 0.0;                         ///< of each sample by itself, or of what they have in common
  double stddev = 0.0;
  double span_in_all_samples = 0.0;
};

double zOf(const std::vector<FrameDeviations>& samples) {
  double excess = 0.0, expected = 0.0;
  for (const FrameDeviations& frames : samples) {
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
  const Alike alike = alikeIn(seen.measured);
  seen.z = std::max(zOf(seen.measured), alike.z);
  if (alike.z >= kStandsOut) seen.span_in_all_samples = alike.span;
  return seen;
}

/// Whether the frames of a world deviate, too.
bool deviateIn(const Replay& replay, const World& world, Channel channel) {
  std::vector<FrameDeviations> simulated;
  for (std::size_t s = 0; s < replay.samples().size(); ++s) {
    const ReplaySample& sample = replay.samples()[s];
    const core::Detections detections = replay.detections(world, s, replay.seed());
    const auto beam_of = beamsOfDetections(detections, sample.beams, {});
    simulated.push_back(
        deviationsOf(sample, detections, beam_of, detections.*kValues[channel], replay.resolution(channel)));
  }
  return std::max(zOf(simulated), alikeIn(simulated).z) >= kStandsOut;
}

/// Discrepancy of the baseline to a measurement from which the common deviation of every frame was taken out.
double discrepancyWithout(const Judge& judge, const Seen& seen, Channel channel) {
  const Replay& replay = judge.replay;
  const Evidence& held_out = judge.split.held_out;
  Measured corrected;
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
  return SimulatedWorld(replay, replay.baseline(), held_out).discrepancyTo(corrected);
}

/// By how much a world differs from the baseline in the means of every channel: root mean square over the cells, in
/// steps of the sensor's output.
std::array<double, kChannels> shiftsOf(const Replay& replay, const Evidence& evidence, const World& world) {
  std::array<double, kChannels> shifts{};
  double count = 0.0;
  for (const std::size_t s : evidence.samples) {
    const int frames = std::min(replay.samples()[s].frames, evidence.most_frames);
    const auto with = replay.simulate(world, s, frames, evidence.seed);
    const auto without = replay.simulate(replay.baseline(), s, frames, evidence.seed);
    for (std::size_t c = 0; c < replay.samples()[s].layout->surfaces(); ++c) {
      if (with[c].count < 1.0 || without[c].count < 1.0) continue;
      for (const Channel channel : replay.channels())
        shifts[channel] += std::pow(with[c].mean(channel) - without[c].mean(channel), 2.0);
      count += 1.0;
    }
  }
  for (const Channel channel : replay.channels())
    shifts[channel] = count > 0.0 ? std::sqrt(shifts[channel] / count) / replay.resolution(channel) : 0.0;
  return shifts;
}

}  // namespace

bool explainsTheirMean(const Judge& judge, const FrameMode& frames, const World& with_cause) {
  const Replay& replay = judge.replay;
  const auto steps = shiftsOf(replay, judge.split.held_out, with_cause);
  const double own = steps[frames.channel];
  const auto& channels = replay.channels();
  if (std::any_of(channels.begin(), channels.end(), [&](Channel channel) { return steps[channel] > own; }))
    return false;
  return frames.span_in_all_samples > kGoodPart * own * replay.resolution(frames.channel);
}

std::optional<FrameMode> frameModeOf(const Judge& judge, const std::optional<World>& with_cause) {
  const Replay& replay = judge.replay;
  if (replay.samples().front().layout->pooled()) return std::nullopt;
  FrameMode mode;
  Seen most;
  for (const Channel channel : replay.channels()) {
    Seen seen = seenIn(replay, channel);
    if (seen.z < kStandsOut || seen.z <= mode.z) continue;
    if (deviateIn(replay, replay.baseline(), channel)) continue;
    if (with_cause && deviateIn(replay, *with_cause, channel)) continue;
    mode.channel = channel;
    mode.z = seen.z;
    mode.stddev = seen.stddev;
    mode.span_in_all_samples = seen.span_in_all_samples;
    most = std::move(seen);
  }
  if (mode.z < kStandsOut) return std::nullopt;
  const double without = discrepancyWithout(judge, most, mode.channel);
  mode.share_of_gap = (judge.yardstick.baseline - without) / judge.yardstick.whole();
  return mode;
}

}  // namespace gap
