#include "gap/candidates/yardstick.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/parallel.h"
#include "gap/replay/statistics.h"

namespace gap {

namespace {

constexpr int kNullRuns = 20;  // their spread is known to a sixth

}  // namespace

double Yardstick::whole() const { return std::max({1e-9, perfect_spread, baseline - perfect}); }

double Yardstick::explained(double discrepancy, double self) const {
  // A world may not buy its share with noise: at least half of the way to a quiet right model counts as the whole way.
  const double whole_way = std::max(baseline - std::max(self, perfect), 0.5 * whole());
  return (baseline - discrepancy) / whole_way;
}

double Yardstick::noiseOfShare() const { return std::sqrt(2.0) * perfect_spread / whole(); }

double Yardstick::z() const { return (baseline - perfect) / std::max(1e-9, perfect_spread); }

double Yardstick::p_value() const { return upperTail(z(), kNullRuns); }

Yardstick yardstickOf(const Replay& replay, const Evidence& held_out) {
  Yardstick yardstick;
  const World& world = replay.baseline();
  const SimulatedWorld simulated(replay, world, held_out, Yardstick::kSimulations);
  yardstick.baseline = simulated.discrepancy();
  std::vector<std::vector<double>> runs(simulated.simulations(), std::vector<double>(kNullRuns));
  core::parallelFor(kNullRuns, 1, [&](std::size_t run, std::size_t) {
    const Measured measured = measuredIn(replay, world, held_out, held_out.seed + 1000 + run);
    for (std::size_t k = 0; k < runs.size(); ++k) runs[k][run] = simulated.discrepancyTo(measured, k);
  });
  double variance = 0.0;
  for (const std::vector<double>& of_one : runs) {
    const Distribution perfect(of_one);
    yardstick.perfect += perfect.mean / static_cast<double>(runs.size());
    variance += perfect.stddev * perfect.stddev / static_cast<double>(runs.size());
  }
  yardstick.perfect_spread = std::sqrt(variance);
  return yardstick;
}

}  // namespace gap
