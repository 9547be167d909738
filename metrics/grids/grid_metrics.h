#pragma once

#include <span>

#include "metrics/grids/map_score.h"
#include "metrics/grids/occupancy_grid.h"
#include "metrics/grids/range_image.h"
#include "metrics/metric_info.h"

namespace metrics {

/// Two occupancy grids, and what may be chosen about their metrics. Referred to, not owned.
struct GridInput {
  const OccupancyGrid& simulated;
  const OccupancyGrid& measured;
  CellLimits limits = {};
  double clip = kUsualClip;  ///< of the map score

  [[nodiscard]] GridPair pair() const noexcept { return {.simulated = simulated, .measured = measured}; }
};

/// Two range images. Referred to, not owned.
struct RangeImageInput {
  const RangeImage& simulated;
  const RangeImage& measured;

  [[nodiscard]] RangeImagePair pair() const noexcept { return {.simulated = simulated, .measured = measured}; }
};

/// Every metric of two occupancy grids, in the order of Tab. 4-3.
[[nodiscard]] std::span<const MetricOf<GridInput>> gridMetrics();

/// Every metric of two range images, in the order of Tab. 4-3. Those of ranges read the pixels with an echo in both
/// images and are NaN if there is none.
[[nodiscard]] std::span<const MetricOf<RangeImageInput>> rangeImageMetrics();

}  // namespace metrics
