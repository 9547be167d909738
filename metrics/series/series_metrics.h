#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "metrics/metric_info.h"
#include "metrics/series/series_pair.h"

namespace metrics {

/// Two series in step, and what may be chosen about their metrics. Referred to, not owned.
struct SeriesInput {
  std::span<const double> simulated;
  std::span<const double> measured;
  std::span<const double> times_s;            ///< of the values, if known: metrics with lags then check the steps
  std::optional<std::size_t> largest_lag;     ///< [values]; without it a quarter of the series (lagged_correlation.h)
  std::optional<std::size_t> warping_window;  ///< [values]; without it time may warp freely (dynamic_time_warping.h)

  [[nodiscard]] SeriesPair pair() const noexcept { return {.simulated = simulated, .measured = measured}; }
};

/// Every metric of two series, in the order of Tab. 4-3.
[[nodiscard]] std::span<const MetricOf<SeriesInput>> seriesMetrics();

}  // namespace metrics
