#pragma once

#include <optional>

#include "metrics/area/area_metric.h"
#include "metrics/area/double_validation_metric.h"
#include "metrics/distributions/comparison.h"
#include "metrics/metric_info.h"

namespace metrics {

/// What may be chosen about the metrics of a comparison of values.
struct MetricOptions {
  Shift shift = Shift::One;           ///< which shift `dvm` uses
  std::optional<double> experiments;  ///< replications for the safety factor of d_mavm; without it n of the measurement
};

/// What every metric of values may read, computed once. Refers to the boxes and samples: they must outlive it.
struct MetricInput {
  /// `samples` are the same values without boxes: all simulated runs pooled into one sample.
  /// Throws InputError if the safety factor's number of experiments is not positive.
  MetricInput(const Comparison& boxes, const SamplePair& samples, const MetricOptions& options = {});

  Comparison boxes;
  SamplePair samples;
  MetricOptions options;
  double experiments;
  AreaPortions portions;
  DoubleValidation one_shift;
  DoubleValidation balanced;
};

using Metric = MetricOf<MetricInput>;

}  // namespace metrics
