#pragma once

#include <span>

#include "metrics/metric_info.h"
#include "metrics/points/point_cloud.h"
#include "metrics/points/point_wasserstein.h"

namespace metrics {

struct PointOptions {
  double wasserstein_order = 1.0;
  Slices slices;
};

/// Two point clouds in one frame, and what may be chosen about their comparison. Results in metres.
struct PointCloudInput {
  CloudPair clouds;
  PointOptions options = {};
};

/// Every metric of two point clouds, one line each in the source.
[[nodiscard]] std::span<const MetricOf<PointCloudInput>> pointMetrics();

}  // namespace metrics
