#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/detections.h"
#include "metrics/metric_catalog.h"

namespace acceptance {

/// Both sides of one sample, the detections outside the gate already dropped.
struct Sides {
  const core::Detections& measured;
  std::span<const core::Detections> simulated;  ///< centre first, then the corners; not empty
  std::string column;                           ///< of the measurand
  metrics::Scale scale;                         ///< of the measurand; what it does not allow is NaN
  int measured_frames;
  int simulated_frames;
  std::size_t beams_per_frame;
};

/// The values of the measurand on both sides. A side that has detections but not this column throws InputError.
struct Distributions {
  std::vector<double> measured;
  std::vector<std::vector<double>> simulated;  ///< one list a run

  /// Only then there is something to compare.
  [[nodiscard]] bool complete() const;
};
[[nodiscard]] Distributions distributionsOf(const Sides& sides);

/// Everything of `wanted` (names of expressionVariables()) and what every report shows; NaN where undefined.
[[nodiscard]] std::map<std::string, double> valuesOf(const Sides& sides, const Distributions& distributions,
                                                     std::span<const std::string> wanted,
                                                     const metrics::MetricOptions& options);

/// Name of the number that an expression sees: "d_bias", or "ks_p_value" for one of several.
[[nodiscard]] std::string variableName(const metrics::Metric& metric, std::size_t part);

/// Whether one of `wanted` is the metric or a number of it.
[[nodiscard]] bool isWanted(const metrics::Metric& metric, std::span<const std::string> wanted);

}  // namespace acceptance
