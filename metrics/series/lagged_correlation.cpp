#include "metrics/series/lagged_correlation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "core/error.h"
#include "metrics/series/centred_series.h"
#include "metrics/series/correlation.h"

namespace metrics {

namespace {

constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();

/// r(lag) with `later` read `lag` values after `earlier`.
double correlationAt(const CentredSeries& earlier, const CentredSeries& later, std::size_t lag) {
  const auto overlap_end = earlier.values.end() - static_cast<std::ptrdiff_t>(lag);
  const auto shifted = later.values.begin() + static_cast<std::ptrdiff_t>(lag);
  const double products = std::inner_product(earlier.values.begin(), overlap_end, shifted, 0.0);
  return std::clamp(products / earlier.norm() / later.norm(), -1.0, 1.0);
}

std::size_t checkedLag(std::optional<std::size_t> largest_lag, std::size_t n) {
  if (!largest_lag) return usualLargestLag(n);
  if (*largest_lag < n) return *largest_lag;
  throw core::InputError(
      {.item = "largest lag"},
      "is " + std::to_string(*largest_lag) + " for series of " + std::to_string(n) + " values; nothing overlaps there.",
      "Give a lag below the number of values.");
}

}  // namespace

std::size_t usualLargestLag(std::size_t n) { return n < 2 ? 0 : std::max<std::size_t>(1, n / 4); }

CrossCorrelation crossCorrelation(const SeriesPair& pair, std::optional<std::size_t> largest_lag) {
  requirePaired(pair);
  const std::size_t last = checkedLag(largest_lag, pair.measured.size());
  if (whyUncorrelated(pair)) return {.maximum = kUndefined, .lag = kUndefined};
  const CentredSeries simulated(pair.simulated);
  const CentredSeries measured(pair.measured);
  CrossCorrelation best = {.maximum = correlationAt(measured, simulated, 0), .lag = 0.0};
  for (std::size_t k = 1; k <= last; ++k) {
    const double simulated_later = correlationAt(measured, simulated, k);
    const double simulated_earlier = correlationAt(simulated, measured, k);
    if (simulated_later > best.maximum) best = {.maximum = simulated_later, .lag = static_cast<double>(k)};
    if (simulated_earlier > best.maximum) best = {.maximum = simulated_earlier, .lag = -static_cast<double>(k)};
  }
  return best;
}

double autocorrelationDifference(const SeriesPair& pair, std::optional<std::size_t> largest_lag) {
  requirePaired(pair);
  const std::size_t last = checkedLag(largest_lag, pair.measured.size());
  if (largest_lag == 0u) {
    throw core::InputError({.item = "largest lag"}, "is 0; at lag 0 every autocorrelation is 1.",
                           "Give at least 1 for the autocorrelation difference.");
  }
  if (whyUncorrelated(pair)) return kUndefined;
  const CentredSeries simulated(pair.simulated);
  const CentredSeries measured(pair.measured);
  double sum = 0.0;
  for (std::size_t k = 1; k <= last; ++k) {
    sum += std::abs(correlationAt(simulated, simulated, k) - correlationAt(measured, measured, k));
  }
  return sum / static_cast<double>(last);
}

}  // namespace metrics
