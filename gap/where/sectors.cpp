#include "gap/where/sectors.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/physics.h"

namespace gap {

namespace {

constexpr std::size_t kMostSectors = 3;  // of each kind
constexpr std::size_t kMostBins = 240;   // of azimuth: all pairs of them are looked at
constexpr double kMostDeviation = 10.0;  // errors: no residual counts more
constexpr double kLeastGain = 25.0;      // squared errors: such a sector is not there by chance
constexpr double kSameAzimuth_deg = 0.01;

/// Residuals of beams in about one direction.
struct Bin {
  double azimuth_deg;
  double sum = 0.0;
  double count = 0.0;
};

std::vector<Bin> binsOf(const Replay& replay, const ResidualTable& table) {
  std::map<long, Bin> by_azimuth;
  for (const ResidualTable::Row& row : table.rows) {
    const ReplaySample& sample = replay.samples()[row.sample];
    const Cell& cell = sample.layout->cells()[row.cell];
    if (cell.at_edge || row.error <= 0.0) continue;
    const double azimuth_deg = sample.beams[cell.beam].azimuth_rad * core::kDegPerRad;
    Bin& bin = by_azimuth.try_emplace(std::lround(azimuth_deg / kSameAzimuth_deg), Bin{azimuth_deg}).first->second;
    bin.sum += std::clamp(row.value / row.error, -kMostDeviation, kMostDeviation);
    bin.count += 1.0;
  }
  const std::size_t together = 1 + by_azimuth.size() / kMostBins;
  std::vector<Bin> bins;
  std::size_t i = 0;
  for (const auto& [key, bin] : by_azimuth) {
    if (i++ % together == 0) bins.push_back({bin.azimuth_deg});
    bins.back().sum += bin.sum;
    bins.back().count += bin.count;
  }
  return bins;
}

struct TwoMeans {
  Sector sector;
  double gain = 0.0;  ///< squared errors that two means explain more than one does
};

/// Borders lie half way between beams.
Sector between(const std::vector<Bin>& bins, std::size_t begin, std::size_t end) {
  const double step_deg = (bins.back().azimuth_deg - bins.front().azimuth_deg) / static_cast<double>(bins.size() - 1);
  const auto borderBefore = [&](std::size_t b) {
    if (b == 0) return bins.front().azimuth_deg - 0.5 * step_deg;
    if (b == bins.size()) return bins.back().azimuth_deg + 0.5 * step_deg;
    return 0.5 * (bins[b - 1].azimuth_deg + bins[b].azimuth_deg);
  };
  return {borderBefore(begin), borderBefore(end)};
}

/// The best sectors that deviate more than the rest does, and less.
struct BestSplits {
  TwoMeans more, less;
};

BestSplits bestSplits(const std::vector<Bin>& bins) {
  double sum = 0.0, count = 0.0;
  for (const Bin& bin : bins) {
    sum += bin.sum;
    count += bin.count;
  }
  BestSplits best;
  for (std::size_t begin = 0; begin < bins.size(); ++begin) {
    double inside = 0.0, count_inside = 0.0;
    for (std::size_t end = begin + 1; end <= bins.size() && end - begin < bins.size(); ++end) {
      inside += bins[end - 1].sum;
      count_inside += bins[end - 1].count;
      const double outside = sum - inside, count_outside = count - count_inside;
      const double gain = inside * inside / count_inside + outside * outside / count_outside - sum * sum / count;
      const bool deviates = std::abs(inside) / count_inside > std::abs(outside) / count_outside;
      TwoMeans& known = deviates ? best.more : best.less;
      if (gain > known.gain) known = {between(bins, begin, end), gain};
    }
  }
  return best;
}

std::vector<Sector> bestOf(std::vector<TwoMeans> splits) {
  std::stable_sort(splits.begin(), splits.end(), [](const TwoMeans& a, const TwoMeans& b) { return a.gain > b.gain; });
  if (splits.size() > kMostSectors) splits.resize(kMostSectors);
  std::vector<Sector> sectors;
  for (const TwoMeans& split : splits) sectors.push_back(split.sector);
  return sectors;
}

}  // namespace

std::vector<Sector> sectorsIn(const Replay& replay, const std::vector<ResidualTable>& tables) {
  if (replay.samples().front().layout->pooled()) return {};  // nobody knows where its detections are
  std::vector<TwoMeans> more, less;
  for (const ResidualTable& table : tables) {
    const std::vector<Bin> bins = binsOf(replay, table);
    if (bins.size() < 2) continue;
    const BestSplits best = bestSplits(bins);
    if (best.more.gain > kLeastGain) more.push_back(best.more);
    if (best.less.gain > std::max(kLeastGain, best.more.gain)) less.push_back(best.less);
  }
  std::vector<Sector> sectors = bestOf(std::move(more));
  for (const Sector& sector : bestOf(std::move(less))) sectors.push_back(sector);
  return sectors;
}

}  // namespace gap
