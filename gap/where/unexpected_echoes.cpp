#include "gap/where/unexpected_echoes.h"

#include <algorithm>
#include <span>

#include "core/physics.h"

namespace gap {

namespace {

constexpr std::size_t kFewest = 5;
constexpr double kMostExpected = 0.5;  // of a beam's echoes

/// Of one beam.
struct Unexpected {
  double range_m, azimuth_deg, count;
};

std::vector<Unexpected> ofBeams(const Replay& replay, const CellsOfSamples& expected, const std::vector<int>& frames) {
  std::vector<Unexpected> all;
  for (std::size_t i = 0; i < replay.samples().size(); ++i) {
    const ReplaySample& sample = replay.samples()[i];
    for (std::size_t c = sample.layout->surfaces(); c < sample.statistics.size(); ++c) {
      const Cell& cell = sample.layout->cells()[c];
      const CellStatistics& measured = sample.statistics[c];
      const double usual = expected[i][c].count * sample.frames / frames[i];
      if (measured.count == 0.0 || usual > kMostExpected * measured.count || cell.at_edge) continue;
      const double azimuth_deg = sample.beams[cell.beam].azimuth_rad * core::kDegPerRad;
      all.push_back({measured.mean(kRange), azimuth_deg, measured.count - usual});
    }
  }
  return all;
}

/// The most echoes that lie within a tenth of their distance (a metre at least); `all` by range. Echoes of a second
/// cause may be spread over all ranges, and would move a mean or median of all to where there are none.
std::span<const Unexpected> densestOf(std::span<const Unexpected> all) {
  std::span<const Unexpected> densest;
  double most = 0.0, count = 0.0;
  for (std::size_t from = 0, to = 0; from < all.size(); ++from) {
    const double end_m = all[from].range_m + std::max(1.0, 0.1 * all[from].range_m);
    for (; to < all.size() && all[to].range_m <= end_m; ++to) count += all[to].count;
    if (count > most) {
      most = count;
      densest = all.subspan(from, to - from);
    }
    count -= all[from].count;
  }
  return densest;
}

}  // namespace

std::optional<UnexpectedEchoes> unexpectedEchoes(const Replay& replay, const CellsOfSamples& expected,
                                                 const std::vector<int>& frames) {
  std::vector<Unexpected> all = ofBeams(replay, expected, frames);
  std::stable_sort(all.begin(), all.end(),
                   [](const Unexpected& a, const Unexpected& b) { return a.range_m < b.range_m; });
  const auto densest = densestOf(all);
  if (densest.size() < kFewest) return std::nullopt;
  std::vector<double> azimuths_deg;
  for (const Unexpected& beam : densest) azimuths_deg.push_back(beam.azimuth_deg);
  std::sort(azimuths_deg.begin(), azimuths_deg.end());
  const double low_deg = azimuths_deg[densest.size() / 4], high_deg = azimuths_deg[densest.size() * 3 / 4];
  return UnexpectedEchoes{0.5 * (low_deg + high_deg), std::max(azimuthStep_deg(replay), 2.0 * (high_deg - low_deg)),
                          densest[densest.size() / 2].range_m};
}

}  // namespace gap
