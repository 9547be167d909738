#pragma once

#include <span>

#include "metrics/value_input.h"

namespace metrics {

/// The list of area metrics: one line a metric, in the order in which results are written.
[[nodiscard]] std::span<const Metric> areaMetrics();

}  // namespace metrics
