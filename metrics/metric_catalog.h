#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "metrics/area/area_metric.h"
#include "metrics/area/double_validation_metric.h"
#include "metrics/distributions/comparison.h"

namespace metrics {

/// What may be chosen about the metrics of a comparison.
struct MetricOptions {
  Shift shift = Shift::One;           ///< which shift `dvm` uses
  std::optional<double> experiments;  ///< replications for the safety factor of d_mavm; without it n of the measurement
};

/// What every metric may read, computed once. Refers to the boxes and samples: they must outlive it.
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

/// How a result is written: 0.1, [0.1, 0.2], or {"left": 0.1, "right": 0.2}.
enum class MetricShape { Number, List, Object };

enum class MetricUnit { Measurand, None };

/// One metric under the name that files and expressions use.
struct Metric {
  std::string_view name;
  std::string_view meaning;  ///< one line, no full stop
  MetricUnit unit;
  MetricShape shape;
  std::vector<std::string_view> parts;                       ///< names of the results in order; empty for a number
  std::vector<double> (*compute)(const MetricInput& input);  ///< as many numbers as parts; NaN where undefined
};

/// Every metric, in the order in which results are written.
[[nodiscard]] std::span<const Metric> metricCatalog();

/// Throws InputError that names the nearest metric if there is none of this name.
[[nodiscard]] const Metric& metricNamed(std::string_view name);

}  // namespace metrics
