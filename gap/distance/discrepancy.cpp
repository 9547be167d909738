#include "gap/distance/discrepancy.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/physics.h"
#include "gap/distance/extra_echoes.h"
#include "gap/distance/lost_echoes.h"
#include "gap/distance/spread.h"

namespace gap {

namespace {

constexpr double kFloorSteps = 0.2;   // of the resolution: smaller mean differences are not worth explaining
constexpr double kRateOfPower = 2.0;  // most that the detection rate changes with the relative power, at the threshold
constexpr double kSureRate = 0.5;     // detections per frame: no group has cells whose rate is known no better
constexpr double kRateFloor = 0.03;   // detections per frame and cell
constexpr double kLostCell = 20.0;    // z per channel of a surface that only one side detects in every frame
constexpr double kMostlyDetected = 0.7;    // of the shots, on both sides: what is lost there is rare
constexpr double kGroupRateFloor = 0.004;  // detections per frame and cell, mean of a group
constexpr std::size_t kGroups = 6;         // groups of like power in which rates are compared

double squaredFloor(const Replay& replay, Channel channel, double value) {
  const double steps = kFloorSteps * replay.resolution(channel);
  const double relative = channel == kIntensity ? kShareError * value : 0.0;
  return steps * steps + relative * relative;
}

/// What the reference's tolerance does to a mean by way of the received power (settle.h moves what is common to a
/// surface; this is for edges, of which every one moves otherwise).
double squaredTolerance(const Replay& replay, const ReplaySample& sample, std::size_t cell, Channel channel,
                        const CellStatistics& simulated) {
  const double of_power = sample.power_deviation[cell], mean = simulated.mean(channel);
  if (of_power == 0.0 || channel == kRange) return 0.0;
  if (channel == kIntensity) return mean * mean * of_power * of_power;
  const model::SensorProfile& sensor = replay.baseline().model.sensor(sample.sample->sensor);
  const double pulse_m = core::kMetresPerNanosecond * sensor.emitter.pulse_fwhm_ns;
  const double of_width = pulse_m * pulse_m / (2.0 * std::numbers::ln2 * std::max(0.2 * pulse_m, mean)) * of_power;
  return of_width * of_width;
}

/// Standard error of a difference of means, of which noise makes so much, with what no number of frames makes smaller.
double errorOf(double squared_noise, const Replay& replay, const ReplaySample& sample, std::size_t cell,
               Channel channel, const CellStatistics& simulated) {
  const double of_jumps = channel == kRange ? sample.jump_variance_m2[cell] : 0.0;
  const double longer_m = channel == kEpw ? sample.layout->cells()[cell].may_be_longer_m : 0.0;
  return std::sqrt(squared_noise + of_jumps + longer_m * longer_m +
                   squaredFloor(replay, channel, simulated.mean(channel)) +
                   squaredTolerance(replay, sample, cell, channel, simulated));
}

/// How far the detections per frame of one cell are apart, in standard errors.
double rateDifference(double measured, int measured_frames, double simulated, int simulated_frames, double of_power) {
  const double rate = (measured + simulated + 0.5) / (measured_frames + simulated_frames + 1.0);
  const double variance = std::max(1e-4, rate <= 1.0 ? rate * (1.0 - rate) : rate);
  const double error =
      variance / measured_frames + variance / simulated_frames + kRateFloor * kRateFloor + of_power * of_power;
  return (measured / measured_frames - simulated / simulated_frames) / std::sqrt(error);
}

/// Detections per frame, pooled over groups of cells: a loss or a false alarm that is rare in every cell.
void addRates(const std::vector<std::size_t>& cells, std::span<const CellStatistics> measured, int measured_frames,
              std::span<const CellStatistics> simulated, int simulated_frames, double& result) {
  for (const auto& [begin, end] : evenParts(cells.size(), kGroups)) {
    const auto size = static_cast<double>(end - begin);
    double m = 0.0, s = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
      m += measured[cells[i]].count / (size * measured_frames);
      s += simulated[cells[i]].count / (size * simulated_frames);
    }
    const double rate = std::clamp(0.5 * (m + s), 0.5 / (size * measured_frames), 1.0);
    const double variance = std::max(rate * (1.0 - rate), 0.02 * rate) / size;
    const double error = variance / measured_frames + variance / simulated_frames + kGroupRateFloor * kGroupRateFloor;
    const double weight = std::sqrt(size);
    result += weight * groupLoss((m - s) / std::sqrt(error));
  }
}

}  // namespace

double robustLoss(double z) { return std::sqrt(1.0 + z * z) - 1.0; }

double groupLoss(double z) { return robustLoss(std::max(0.0, std::abs(z) - 1.0)); }

bool takesPart(const ReplaySample& sample, const Cell& cell, Part part) {
  if (!part.edges && cell.at_edge) return false;
  if (part.half == Half::kAll) return true;
  const model::Beam& beam = sample.beams[cell.beam];
  const bool odd = ((beam.column + beam.layer) & 1) != 0;  // like the squares of a chessboard
  return odd == (part.half == Half::kOdd);
}

double comparableError(const Replay& replay, const ReplaySample& sample, std::size_t cell, Channel channel,
                       const CellStatistics& measured, const CellStatistics& simulated) {
  const double variance = pooledVariance(measured, simulated, channel, priorVariance(replay, sample, channel));
  return errorOf(variance / measured.count + variance / simulated.count, replay, sample, cell, channel, simulated);
}

double meanError(const Replay& replay, const ReplaySample& sample, std::size_t cell, Channel channel,
                 const CellStatistics& measured, const CellStatistics& simulated) {
  const double prior = replay.resolution(channel) * replay.resolution(channel) / 12.0;
  const double variance = pooledVariance(measured, simulated, channel, prior);
  return errorOf(variance / measured.count + variance / simulated.count, replay, sample, cell, channel, simulated);
}

namespace {

/// Means and spreads of the surfaces that both sides detect, which are in order of power. The noise of a mean is that
/// of its own side: under the noise of the profile a world that is right to scatter more would pay for it in its means,
/// the more the fewer frames of it are simulated.
double ofValues(const Replay& replay, const Comparison& comparison, const std::vector<std::size_t>& surfaces,
                Channel channel, const Aspects& aspects) {
  constexpr double kMostOfMeasured = 2.0;  // variance: no world may excuse its means by its noise
  const ReplaySample& sample = replay.samples()[comparison.sample];
  const double of_step = replay.resolution(channel) * replay.resolution(channel) / 12.0;
  const double prior = priorVariance(replay, sample, channel);
  const std::vector<GroupSpread> groups = spreadsOf(surfaces, comparison, channel, prior);
  double result = aspects.spreads[channel] ? spreadDiscrepancy(groups, prior) : 0.0;
  if (!aspects.means[channel]) return result;
  for (const GroupSpread& group : groups) {
    for (const std::size_t c : group.cells) {
      const CellStatistics &m = comparison.measured[c], &s = comparison.simulated[c];
      if (m.count == 0.0 || s.count == 0.0) continue;
      const double of_measured = std::max(of_step, varianceIn(group.measured, m, channel, prior));
      const double of_simulated =
          std::clamp(varianceIn(group.simulated, s, channel, prior), of_step, kMostOfMeasured * of_measured);
      const double error = errorOf(of_measured / m.count + of_simulated / s.count, replay, sample, c, channel, s);
      result += robustLoss((m.mean(channel) - s.mean(channel)) / error);
    }
  }
  return result;
}

/// Of a cell that only one side detects. No mean to compare must not be cheaper than a wrong one, or losing all
/// detections would explain everything: where the world loses what was measured, every channel is as wrong as it was
/// without a cause.
double ofLostCell(const Replay& replay, const ReplaySample& sample, std::size_t cell, const CellStatistics& measured,
                  double lost, const Aspects& aspects) {
  const CellStatistics& baseline = sample.baseline[cell];
  const bool known = lost > 0.0 && measured.count > 0.0 && baseline.count > 0.0;
  double result = 0.0;
  for (const Channel channel : replay.channels()) {
    if (!aspects.ask(channel)) continue;
    double z = lost;
    if (known) {
      const double error = comparableError(replay, sample, cell, channel, measured, baseline);
      z = std::max(z, std::abs(measured.mean(channel) - baseline.mean(channel)) / error);
    }
    result += robustLoss(z);
  }
  return result;
}

/// Surfaces of a sample that any side detects, in order of the power that they should send back.
std::vector<std::size_t> surfacesOf(const Comparison& comparison, const ReplaySample& sample, Part part) {
  const auto& cells = sample.layout->cells();
  std::vector<std::size_t> surfaces;
  for (std::size_t c = 0; c < sample.layout->surfaces(); ++c) {
    if (comparison.measured[c].count == 0.0 && comparison.simulated[c].count == 0.0) continue;
    if (takesPart(sample, cells[c], part)) surfaces.push_back(c);
  }
  std::stable_sort(surfaces.begin(), surfaces.end(), [&](std::size_t a, std::size_t b) {
    return cells[a].power_over_threshold < cells[b].power_over_threshold;
  });
  return surfaces;
}

/// Whether there are echoes, what those are like that no surface makes, and what it costs a world to have no value
/// where one is asked for. `surfaces`: surfacesOf.
double ofExistence(const Replay& replay, const Comparison& comparison, Part part,
                   const std::vector<std::size_t>& surfaces) {
  const auto& [index, measured, measured_frames, simulated, simulated_frames] = comparison;
  const ReplaySample& sample = replay.samples()[index];
  const auto& cells = sample.layout->cells();
  const bool exists = part.aspects.existence;
  double result = 0.0;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (!takesPart(sample, cells[c], part)) continue;
    const CellStatistics &m = measured[c], &s = simulated[c];
    if (m.count == 0.0 && s.count == 0.0) continue;
    const bool surface = c < sample.layout->surfaces();
    // A rare echo from nowhere, which no world puts into the same beam, is left to extraDiscrepancy; so is one beside
    // an edge: whether a beam still grazes a bright surface, a millimetre decides, or the number of rays.
    const bool often =
        std::max(m.count / measured_frames, s.count / simulated_frames) >= kOftenDetected && !cells[c].at_edge;
    if (exists && !sample.layout->pooled() && (surface || often)) {
      const double z =
          rateDifference(m.count, measured_frames, s.count, simulated_frames, kRateOfPower * sample.power_deviation[c]);
      // A world that loses as many shots as were lost would pay for each that another cell lost: its rate would come
      // out low. So rare losses do not count one by one where lostDiscrepancy sees all of them.
      const bool rare = std::min(m.count / measured_frames, s.count / simulated_frames) >= kMostlyDetected;
      result += rare && surface && losesNothing(cells[c]) ? groupLoss(z) : robustLoss(z);
    }
    if (!surface && (!often || !exists)) continue;
    const double rate = std::max(m.count / measured_frames, s.count / simulated_frames);
    const double lost = kLostCell * std::max(0.0, rate - kOftenDetected - kRateOfPower * sample.power_deviation[c]);
    if (m.count == 0.0 || s.count == 0.0) {
      result += ofLostCell(replay, sample, c, m, lost, part.aspects);
      continue;
    }
    if (surface) continue;
    for (const Channel channel : replay.channels()) {
      const double z = std::abs(m.mean(channel) - s.mean(channel)) / comparableError(replay, sample, c, channel, m, s);
      // Two echoes that no surface makes may have nothing to do with each other: then one is lost, the other made up.
      result += robustLoss(std::min(z, lost));
    }
  }
  if (exists && !sample.layout->pooled()) {
    std::vector<std::size_t> sure = surfaces;
    std::erase_if(sure, [&](std::size_t c) { return kRateOfPower * sample.power_deviation[c] > kSureRate; });
    addRates(sure, measured, measured_frames, simulated, simulated_frames, result);
  }
  return result;
}

/// Of one sample, but for rare echoes from nowhere.
double ofSample(const Replay& replay, const Comparison& comparison, Part part) {
  const std::vector<std::size_t> surfaces = surfacesOf(comparison, replay.samples()[comparison.sample], part);
  double result = ofExistence(replay, comparison, part, surfaces);
  for (const Channel channel : replay.channels())
    result += ofValues(replay, comparison, surfaces, channel, part.aspects);
  return result;
}

}  // namespace

double discrepancy(const Replay& replay, std::span<const Comparison> comparisons, Part part) {
  double sum = 0.0;
  if (part.aspects.existence)
    sum = extraDiscrepancy(replay, comparisons, part) + lostDiscrepancy(replay, comparisons, part);
  for (const Comparison& comparison : comparisons) sum += ofSample(replay, comparison, part);
  return sum;
}

}  // namespace gap
