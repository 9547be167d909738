#include "metrics/series/dynamic_time_warping.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "core/error.h"

namespace metrics {

namespace {

/// Half width of the band: all of it if nothing is said.
std::size_t bandOf(std::optional<std::size_t> window, std::size_t longer, std::size_t shorter) {
  if (!window || *window >= longer) return longer;
  if (*window >= longer - shorter) return *window;
  throw core::InputError({.item = "warping window"},
                         "is " + std::to_string(*window) + "; series of " + std::to_string(longer) + " and " +
                             std::to_string(shorter) + " values cannot be matched to their ends within it.",
                         "Give at least " + std::to_string(longer - shorter) + ", the difference of the lengths.");
}

}  // namespace

double dynamicTimeWarping(const SeriesPair& series, std::optional<std::size_t> window) {
  requireFinite(series);
  const bool more_simulated = series.simulated.size() > series.measured.size();
  const std::span<const double> rows = more_simulated ? series.simulated : series.measured;
  const std::span<const double> columns = more_simulated ? series.measured : series.simulated;
  const std::size_t band = bandOf(window, rows.size(), columns.size());

  // Two rows of D with a border of infinity at column 0; D(0, 0) = 0 starts the path.
  constexpr double kUnreachable = std::numeric_limits<double>::infinity();
  std::vector<double> before(columns.size() + 1, kUnreachable);
  std::vector<double> now(columns.size() + 1, kUnreachable);
  before[0] = 0.0;
  for (std::size_t i = 1; i <= rows.size(); ++i) {
    const std::size_t first = i > band ? i - band : 1;
    const std::size_t last = std::min(columns.size(), i + band);
    now[first - 1] = kUnreachable;  // left of the band stands an older row; right of it nothing was written yet
    for (std::size_t j = first; j <= last; ++j) {
      now[j] = std::abs(rows[i - 1] - columns[j - 1]) + std::min({before[j], before[j - 1], now[j - 1]});
    }
    std::swap(before, now);
  }
  return before.back();
}

}  // namespace metrics
