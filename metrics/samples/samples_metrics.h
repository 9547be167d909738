#pragma once

#include <span>

#include "metrics/distributions/comparison.h"
#include "metrics/metric_info.h"

namespace metrics {

/// The list of metrics of two samples: one entry a metric, in the order in which results are written. Not here: the
/// mean error (number 3) and others that need values in pairs (metrics/series), and the frequency of positive tests
/// over many pairs (positive_ks_tests.h), of which `ks_positive` is the case of one.
[[nodiscard]] std::span<const MetricOf<SamplePair>> samplesMetrics();

}  // namespace metrics
