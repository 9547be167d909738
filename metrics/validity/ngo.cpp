#include "metrics/validity/ngo.h"

#include <cmath>
#include <fmt/format.h>
#include <numeric>

#include "core/error.h"

namespace metrics {

namespace {

double scaled(const FidelityLevel& level, const ScaledMetric& metric) {
  const core::Place place{.item = fmt::format("level '{}', metric '{}'", level.name, metric.name)};
  if (!(metric.maximum > 0.0) || !std::isfinite(metric.maximum)) {
    throw core::InputError(place, fmt::format("has maximum {}; it must be positive.", metric.maximum),
                           "Give the value that counts as the largest gap.");
  }
  if (!(metric.value >= 0.0) || metric.value > metric.maximum) {
    throw core::InputError(place, fmt::format("is {}, not between 0 and its maximum {}.", metric.value, metric.maximum),
                           "Give a metric that is 0 at best, and a maximum that no compared model exceeds.");
  }
  return metric.value / metric.maximum;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

NgoGap ngoGap(std::span<const FidelityLevel> levels) {
  if (levels.empty()) throw core::InputError({}, "no fidelity level.", "Give at least one; the paper has four.");
  NgoGap result{.gap = 0.0, .levels = {}};
  for (const FidelityLevel& level : levels) {
    if (level.metrics.empty()) {
      throw core::InputError({.item = fmt::format("level '{}'", level.name)}, "has no metrics.",
                             "Give at least one, or leave the level out.");
    }
    std::vector<double> values;
    for (const ScaledMetric& metric : level.metrics) values.push_back(scaled(level, metric));
    result.levels.push_back(mean(values));
  }
  result.gap = mean(result.levels);
  return result;
}

}  // namespace metrics
