#include "gap/distance/extra_echoes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "gap/distance/discrepancy.h"

namespace gap {

namespace {

constexpr std::size_t kGroups = 6;
constexpr double kEdgeFloor = 0.004;   // detections per frame and beam: what the reference leaves open at edges
constexpr double kClearFloor = 2e-4;   // elsewhere: nothing but counting
constexpr double kMostDeviation = 10;  // z of a mean or a spread; what one side lacks altogether costs as much
constexpr double kFewest = 5.0;        // detections that make a mean
constexpr double kMany = 30.0;         // that tell a sample from others
constexpr double kSpreadError = 0.15;  // of the logarithm of a variance: such echoes are far from normal

/// Detections of some cells, and in how many frames.
struct Side {
  std::span<const CellStatistics> statistics;
  int frames;

  [[nodiscard]] double rate(const std::vector<std::size_t>& cells, std::size_t begin, std::size_t end) const {
    double count = 0.0;
    for (std::size_t i = begin; i < end; ++i) count += statistics[cells[i]].count;
    return count / (static_cast<double>(end - begin) * frames);
  }
  [[nodiscard]] CellStatistics together(const std::vector<std::size_t>& cells) const {
    CellStatistics sum;
    for (const std::size_t c : cells) sum += statistics[c];
    return sum;
  }
};

/// What both sides have from nowhere, of one sample or of several.
struct Extras {
  CellStatistics measured, simulated;
  std::size_t beams = 0;

  void add(const Extras& more) {
    measured += more.measured;
    simulated += more.simulated;
    beams += more.beams;
  }
};

/// Detections per frame in so many groups of beams.
double ofRates(const std::vector<std::size_t>& cells, const Side& measured, const Side& simulated, double floor,
               std::size_t most_groups) {
  double result = 0.0;
  const auto groups = evenParts(cells.size(), most_groups);
  for (const auto& [begin, end] : groups) {
    const auto size = static_cast<double>(end - begin);
    const double m = measured.rate(cells, begin, end), s = simulated.rate(cells, begin, end);
    // One detection more than there were: a count of zero is no proof of a rate of zero.
    const double rate = 0.5 * (m + s) + 0.5 / (size * (measured.frames + simulated.frames));
    const double error = rate / size * (1.0 / measured.frames + 1.0 / simulated.frames) + floor * floor;
    const double z = (m - s) / std::sqrt(error);
    result += groups.size() > 1 ? groupLoss(z) : robustLoss(z);
  }
  return std::sqrt(static_cast<double>(cells.size()) / static_cast<double>(groups.size())) * result;
}

double ofValues(const Replay& replay, const Extras& extras) {
  const CellStatistics &m = extras.measured, &s = extras.simulated;
  if (m.count < kFewest && s.count < kFewest) return 0.0;
  // No world may save itself a wrong mean by having none; nor does the step from few to enough cost anything.
  const double most = std::min(kMostDeviation, std::sqrt(std::max(m.count, s.count)) - std::sqrt(kFewest));
  double result = 0.0;
  for (const Channel channel : replay.channels()) {
    double of_mean = most, of_spread = most;
    if (m.count >= kFewest && s.count >= kFewest) {
      const double step = replay.resolution(channel), small = step * step / 12.0;
      const double vm = m.variance(channel) + small, vs = s.variance(channel) + small;
      of_mean = (m.mean(channel) - s.mean(channel)) / std::sqrt(vm / m.count + vs / s.count + small);
      of_spread =
          std::log(vm / vs) / std::sqrt(2.0 / (m.count - 1.0) + 2.0 / (s.count - 1.0) + kSpreadError * kSpreadError);
    }
    result += groupLoss(std::min(most, std::abs(of_mean))) + groupLoss(std::min(most, std::abs(of_spread)));
  }
  return std::sqrt(static_cast<double>(extras.beams) / static_cast<double>(kGroups)) * result;
}

/// Of one sample: adds what its rates deviate to `result`, and returns its extras off all edges.
Extras compare(const Replay& replay, const Comparison& comparison, Part part, double& result) {
  const ReplaySample& sample = replay.samples()[comparison.sample];
  const auto& cells = sample.layout->cells();
  std::vector<std::size_t> clear, edges;
  for (std::size_t c = sample.layout->surfaces(); c < cells.size(); ++c) {
    if (takesPart(sample, cells[c], part)) (cells[c].at_edge ? edges : clear).push_back(c);
  }
  const Side measured{comparison.measured, comparison.measured_frames};
  const Side simulated{comparison.simulated, comparison.simulated_frames};
  if (!edges.empty()) result += ofRates(edges, measured, simulated, kEdgeFloor, kGroups);
  // What is rare shows in all beams together, where it comes from in groups of them.
  if (!clear.empty())
    result +=
        ofRates(clear, measured, simulated, kClearFloor, 1) + ofRates(clear, measured, simulated, kClearFloor, kGroups);
  return {measured.together(clear), simulated.together(clear), clear.size()};
}

}  // namespace

double extraDiscrepancy(const Replay& replay, std::span<const Comparison> comparisons, Part part) {
  double result = 0.0;
  std::map<std::string, Extras> few;  // by sensor
  for (const Comparison& comparison : comparisons) {
    const ReplaySample& sample = replay.samples()[comparison.sample];
    if (sample.layout->pooled()) continue;
    const Extras extras = compare(replay, comparison, part, result);
    if (extras.measured.count >= kMany) {
      result += ofValues(replay, extras);
    } else {
      few[sample.sample->sensor].add(extras);
    }
  }
  for (const auto& [sensor, extras] : few) result += ofValues(replay, extras);
  return result;
}

}  // namespace gap
