#include "model/signal/intruders.h"

#include <algorithm>
#include <cmath>

namespace model {

namespace {

/// On the range axis.
struct Extent {
  double rise_m, fall_m;
};

Extent extentOf(const Echo& echo, RangeMode mode) {
  const double width_m = echo.epw_m / 2.0;  // EPW is not halved
  const double rise_m = mode == RangeMode::kLeadingEdge ? echo.range_m : echo.range_m - 0.5 * width_m;
  return {rise_m, rise_m + width_m};
}

Echo merged(const Echo& a, const Echo& b, RangeMode mode) {
  const Extent of_a = extentOf(a, mode), of_b = extentOf(b, mode);
  const double rise_m = std::min(of_a.rise_m, of_b.rise_m), fall_m = std::max(of_a.fall_m, of_b.fall_m);
  Echo echo = a.peak_w >= b.peak_w ? a : b;
  echo.epw_m = 2.0 * (fall_m - rise_m);
  if (mode == RangeMode::kLeadingEdge) echo.range_m = rise_m;
  if (mode == RangeMode::kCentre) echo.range_m = 0.5 * (rise_m + fall_m);
  return echo;
}

}  // namespace

void mergeIntruders(std::vector<Echo>& echoes, std::size_t first, const DetectionStage& stage) {
  for (std::size_t i = first; i < echoes.size(); ++i) {
    Echo* nearest = nullptr;
    double distance_m = stage.echo_separation_m;
    for (std::size_t e = 0; e < i; ++e) {
      const double apart_m = std::abs(echoes[e].range_m - echoes[i].range_m);
      if (echoes[e].fate != Fate::kDetected || apart_m >= distance_m) continue;
      nearest = &echoes[e];
      distance_m = apart_m;
    }
    if (nearest == nullptr) continue;
    *nearest = merged(*nearest, echoes[i], stage.range_mode);
    echoes[i].fate = Fate::kMerged;
  }
}

}  // namespace model
