#include "model/signal/merging.h"

#include <algorithm>
#include <cmath>

namespace model {

namespace {

void join(Stretch& into, const Stretch& other) {
  if (other.rise_m < into.rise_m) {
    into.rise_m = other.rise_m;
    into.rise_per_width_m = other.rise_per_width_m;
  }
  if (other.fall_m > into.fall_m) {
    into.fall_m = other.fall_m;
    into.fall_per_width_m = other.fall_per_width_m;
  }
  if (other.peak_w <= into.peak_w) return;
  into.peak_w = other.peak_w;
  into.noise_w = other.noise_w;
  into.peak_m = other.peak_m;
  into.peak_per_width = other.peak_per_width;
}

/// The stretch that would be reported so, its peak where its range is.
Stretch stretchOf(const Echo& echo, RangeMode mode) {
  const double width_m = echo.epw_m / 2.0;  // EPW is not halved
  const double rise_m = mode == RangeMode::kLeadingEdge ? echo.range_m : echo.range_m - 0.5 * width_m;
  const double edge_per_width_m = echo.epw_per_width_m / 4.0;  // as if both did the same
  return {.rise_m = rise_m,
          .fall_m = rise_m + width_m,
          .peak_m = echo.range_m,
          .peak_w = echo.peak_w,
          .noise_w = echo.noise_w,
          .rise_per_width_m = -edge_per_width_m,
          .fall_per_width_m = edge_per_width_m,
          .peak_per_width = echo.peak_per_width};
}

}  // namespace

void mergeNearStretches(std::vector<Stretch>& stretches, double separation_m) {
  std::sort(stretches.begin(), stretches.end(), [](const Stretch& a, const Stretch& b) { return a.peak_m < b.peak_m; });
  std::size_t kept = 0;
  double last_peak_m = 0.0;
  for (const Stretch& stretch : stretches) {
    if (kept > 0 && stretch.peak_m - last_peak_m < separation_m) {
      join(stretches[kept - 1], stretch);
    } else {
      stretches[kept++] = stretch;
    }
    last_peak_m = stretch.peak_m;
  }
  stretches.resize(kept);
}

Echo echoOf(const Stretch& stretch, RangeMode mode) {
  Echo echo;
  switch (mode) {
    case RangeMode::kPeak:
      echo.range_m = stretch.peak_m;
      break;
    case RangeMode::kLeadingEdge:
      echo.range_m = stretch.rise_m;
      break;
    case RangeMode::kCentre:
      echo.range_m = 0.5 * (stretch.rise_m + stretch.fall_m);
      break;
  }
  echo.epw_m = 2.0 * (stretch.fall_m - stretch.rise_m);  // r = c t / 2, so c·Δt = 2·Δr
  echo.peak_w = stretch.peak_w;
  echo.noise_w = stretch.noise_w;
  echo.epw_per_width_m = 2.0 * (stretch.fall_per_width_m - stretch.rise_per_width_m);
  echo.peak_per_width = stretch.peak_per_width;
  return echo;
}

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
    Stretch both = stretchOf(*nearest, stage.range_mode);
    join(both, stretchOf(echoes[i], stage.range_mode));
    *nearest = echoOf(both, stage.range_mode);
    echoes[i].fate = Fate::kMerged;
  }
}

}  // namespace model
