#include "gap/distance/lost_echoes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "gap/distance/discrepancy.h"

namespace gap {

namespace {

constexpr double kSure = 2.0;      // times the threshold
constexpr double kFloor = 0.001;   // of the shots
constexpr double kOfLosses = 0.1;  // programs agree no better on losses that are not rare
constexpr double kOneMore = 0.5;   // loss on each side: none seen is no proof of a rate of zero

/// Shots at such surfaces, and those without an echo.
struct Losses {
  double shots = 0.0, lost = 0.0;

  void add(const CellStatistics& cell, int frames) {
    shots += frames;
    lost += std::max(0.0, frames - cell.count);
  }
  [[nodiscard]] double rate() const { return lost / shots; }
};

/// Of all samples of one sensor.
struct BothSides {
  Losses measured, simulated;
  double cells = 0.0;

  [[nodiscard]] double discrepancy() const {
    const double all = measured.shots + simulated.shots;
    const double rate = (measured.lost + simulated.lost + 2.0 * kOneMore) / (all + 2.0 * kOneMore);
    const double floor = kFloor + kOfLosses * rate;
    const double variance = rate * (1.0 - rate) * (1.0 / measured.shots + 1.0 / simulated.shots) + floor * floor;
    return std::sqrt(cells) * groupLoss((measured.rate() - simulated.rate()) / std::sqrt(variance));
  }
};

}  // namespace

bool losesNothing(const Cell& cell) { return !cell.at_edge && cell.power_over_threshold >= kSure; }

double lostDiscrepancy(const Replay& replay, std::span<const Comparison> comparisons, Part part) {
  std::map<std::string, BothSides> by_sensor;
  for (const Comparison& comparison : comparisons) {
    const ReplaySample& sample = replay.samples()[comparison.sample];
    if (sample.layout->pooled()) continue;
    BothSides& sides = by_sensor[sample.sample->sensor];
    for (std::size_t c = 0; c < sample.layout->surfaces(); ++c) {
      const Cell& cell = sample.layout->cells()[c];
      if (!losesNothing(cell) || !takesPart(sample, cell, part)) continue;
      sides.measured.add(comparison.measured[c], comparison.measured_frames);
      sides.simulated.add(comparison.simulated[c], comparison.simulated_frames);
      sides.cells += 1.0;
    }
  }
  double sum = 0.0;
  for (const auto& [sensor, sides] : by_sensor) sum += sides.cells > 0.0 ? sides.discrepancy() : 0.0;
  return sum;
}

}  // namespace gap
