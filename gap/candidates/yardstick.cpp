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
  const SimulatedWorld simulated(replay, world, held_out);
  yardstick.baseline = simulated.discrepancy();
  std::vector<double> runs(kNullRuns);
  core::parallelFor(kNullRuns, 1, [&](std::size_t begin, std::size_t) {
    runs[begin] = simulated.discrepancyTo(measuredIn(replay, world, held_out, held_out.seed + 1000 + begin));
  });
  const Distribution perfect(runs);
  yardstick.perfect = perfect.mean;
  yardstick.perfect_spread = perfect.stddev;
  return yardstick;
}

}  // namespace gap
