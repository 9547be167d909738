#include "gap/candidates/signatures.h"

#include <algorithm>
#include <cmath>

#include "gap/distance/discrepancy.h"
#include "gap/distance/settle.h"

namespace gap {

namespace {

constexpr std::size_t kMostCells = 1200;  // of all samples together
constexpr std::size_t kGroups = 6;        // of like power, for rates and spreads, as in `discrepancy`
constexpr double kRateError = 0.05;       // detections per frame and cell
constexpr double kGroupRateError = 0.006;
constexpr double kSpreadError = 0.07;  // of the logarithm of a variance

/// Of a mean over `cells`, if about a tenth of the detections is lost.
double rateError(double floor, double cells, int measured_frames, int simulated_frames) {
  constexpr double kVariance = 0.1 * 0.9;
  return std::sqrt(floor * floor + kVariance / cells * (1.0 / measured_frames + 1.0 / simulated_frames));
}

double rateOf(const CellStatistics& s, int frames) { return s.count / frames; }

/// Logarithm of the variance within some cells; `small` keeps quiet cells finite.
double logSpread(const std::vector<CellStatistics>& statistics, const std::vector<std::size_t>& cells,
                 std::size_t begin, std::size_t end, Channel channel, double small) {
  double squares = 0.0, dof = 0.0;
  for (std::size_t i = begin; i < end; ++i) {
    const CellStatistics& s = statistics[cells[i]];
    if (s.count < 2.0) continue;
    squares += (s.count - 1.0) * s.variance(channel);
    dof += s.count - 1.0;
  }
  return dof > 0.0 ? std::log(squares / dof + small) : std::log(small);
}

std::vector<std::size_t> everyNth(std::vector<std::size_t> list, std::size_t n) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < list.size(); i += n) kept.push_back(list[i]);
  return kept;
}

}  // namespace

SignatureSpace::SignatureSpace(const Replay& replay, std::vector<std::size_t> samples, int frames, std::uint64_t seed,
                               double most_errors)
    : replay_(replay), frames_(frames), seed_(seed), most_errors_(most_errors), samples_(std::move(samples)) {
  std::size_t all = 0;
  for (const std::size_t s : samples_) all += replay.samples()[s].layout->surfaces();
  const std::size_t stride = std::max<std::size_t>(1, all / kMostCells);
  std::vector<Comparison> comparisons;
  for (const std::size_t s : samples_) {
    const ReplaySample& sample = replay.samples()[s];
    const auto& cells = sample.layout->cells();
    std::vector<std::size_t> surfaces;
    for (std::size_t c = 0; c < sample.layout->surfaces(); ++c) surfaces.push_back(c);
    std::stable_sort(surfaces.begin(), surfaces.end(), [&](std::size_t a, std::size_t b) {
      return cells[a].power_over_threshold < cells[b].power_over_threshold;
    });
    cells_.push_back(everyNth(surfaces, stride));
    baseline_.push_back(replay.simulate(replay.baseline(), s, frames, seed));
    comparisons.push_back({s, sample.statistics, sample.frames, baseline_.back(), frames});
  }
  settle(replay, replay.baseline(), comparisons, {});
  for (std::size_t p = 0; p < samples_.size(); ++p) {
    const ReplaySample& sample = replay.samples()[samples_[p]];
    const Signature part = shifts(p, sample.statistics, sample.frames, comparisons[p].simulated);
    measured_.insert(measured_.end(), part.begin(), part.end());
  }
}

Signature SignatureSpace::shifts(std::size_t part, const std::vector<CellStatistics>& of, int frames,
                                 const std::vector<CellStatistics>& from) const {
  const ReplaySample& sample = replay_.samples()[samples_[part]];
  const auto& cells = cells_[part];
  Signature signature;
  const auto put = [&](double shift_in_errors) {
    signature.push_back(static_cast<float>(std::clamp(shift_in_errors, -most_errors_, most_errors_)));
  };
  for (const std::size_t c : cells) {
    const CellStatistics &a = of[c], &b = from[c], &scale = baseline_[part][c];
    put((rateOf(a, frames) - rateOf(b, frames_)) / rateError(kRateError, 1.0, sample.frames, frames_));
    for (const Channel channel : replay_.channels()) {
      const bool both = a.count > 0.0 && b.count > 0.0 && scale.count > 0.0;
      const CellStatistics& m = sample.statistics[c].count > 0.0 ? sample.statistics[c] : scale;
      put(both ? (a.mean(channel) - b.mean(channel)) / comparableError(replay_, sample, c, channel, m, scale) : 0.0);
    }
  }
  const std::size_t groups = std::min(kGroups, cells.size());
  for (std::size_t g = 0; g < groups; ++g) {
    const std::size_t begin = cells.size() * g / groups, end = cells.size() * (g + 1) / groups;
    const double size = static_cast<double>(end - begin), weight = std::sqrt(std::sqrt(size));
    double rate = 0.0;
    for (std::size_t i = begin; i < end; ++i) rate += (rateOf(of[cells[i]], frames) - rateOf(from[cells[i]], frames_));
    put(weight * rate / size / rateError(kGroupRateError, size, sample.frames, frames_));
    for (const Channel channel : replay_.channels()) {
      const double step = replay_.resolution(channel), small = 0.02 * step * step;
      put(weight *
          (logSpread(of, cells, begin, end, channel, small) - logSpread(from, cells, begin, end, channel, small)) /
          kSpreadError);
    }
  }
  // Detections where nothing is expected, over thirds of the beams.
  const std::size_t first = sample.layout->surfaces(), extras = sample.layout->cells().size() - first;
  constexpr std::size_t kThirds = 3;
  for (std::size_t g = 0; g < kThirds && extras > 0; ++g) {
    double rate = 0.0;
    const std::size_t begin = first + extras * g / kThirds, end = first + extras * (g + 1) / kThirds;
    for (std::size_t c = begin; c < end; ++c) rate += rateOf(of[c], frames) - rateOf(from[c], frames_);
    const double size = std::max(1.0, static_cast<double>(end - begin));
    put(std::sqrt(std::sqrt(size)) * rate / size / kGroupRateError);
  }
  return signature;
}

Signature SignatureSpace::of(const World& world) const {
  Signature signature;
  signature.reserve(size());
  for (std::size_t p = 0; p < samples_.size(); ++p) {
    const Signature part = shifts(p, replay_.simulate(world, samples_[p], frames_, seed_), frames_, baseline_[p]);
    signature.insert(signature.end(), part.begin(), part.end());
  }
  return signature;
}

}  // namespace gap
