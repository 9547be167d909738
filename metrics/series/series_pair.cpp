#include "metrics/series/series_pair.h"

#include <cmath>
#include <string>

#include "core/error.h"
#include "core/text.h"

namespace metrics {

namespace {

void requireFinite(std::span<const double> values, const std::string& name) {
  if (values.empty()) {
    throw core::InputError({.item = name}, "has no values.", "Give at least one.");
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i])) continue;
    throw core::InputError({.item = name + ", value " + std::to_string(i + 1)},
                           "is " + core::shortestNumber(values[i]) + "; it must be finite.",
                           "Remove it on both sides, or say which value stands for a missing one and why.");
  }
}

}  // namespace

void requireFinite(const SeriesPair& pair) {
  requireFinite(pair.simulated, "simulated series");
  requireFinite(pair.measured, "measured series");
}

void requirePaired(const SeriesPair& pair) {
  requireFinite(pair);
  if (pair.simulated.size() == pair.measured.size()) return;
  throw core::InputError({.item = "simulated and measured series"},
                         "have " + std::to_string(pair.simulated.size()) + " and " +
                             std::to_string(pair.measured.size()) + " values; they are compared value by value.",
                         "Resample both to the same instants, or use a metric of distributions or time warping.");
}

void requireEvenSteps(std::span<const double> times_s, std::size_t n) {
  if (times_s.size() != n) {
    throw core::InputError({.item = "times"},
                           "are " + std::to_string(times_s.size()) + " for " + std::to_string(n) + " values.",
                           "Give one time for each value, or none.");
  }
  requireFinite(times_s, "times");
  if (n < 2) return;
  const double mean_step_s = (times_s.back() - times_s.front()) / static_cast<double>(n - 1);
  for (std::size_t i = 1; i < n; ++i) {
    const double step_s = times_s[i] - times_s[i - 1];
    if (step_s > 0.0 && std::abs(step_s - mean_step_s) <= 0.5 * mean_step_s) continue;
    throw core::InputError({.item = "times, value " + std::to_string(i + 1)},
                           "comes " + core::significant(step_s) + " s after the one before; the mean step is " +
                               core::significant(mean_step_s) + " s.",
                           "Sort by time and resample to even steps: lags are counted in values.");
  }
}

}  // namespace metrics
