#include "metrics/area/largest_area_metric.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "metrics/area/area_metric.h"
#include "metrics/area/edge_levels.h"
#include "metrics/distributions/summation.h"

namespace metrics {

namespace {

double costOf(const EdgeLevel& level, double q) {
  return std::max({0.0, level.measured.low - q, q - level.measured.high});
}

/// The larger cost at every level, if these choices rise as quantiles must.
std::optional<double> levelByLevel(const std::vector<EdgeLevel>& levels) {
  Summation sum;
  double last = -std::numeric_limits<double>::infinity();
  for (const EdgeLevel& level : levels) {
    const Interval& inside = level.simulated;
    const double cost_low = costOf(level, inside.low);
    const double cost_high = costOf(level, inside.high);
    const bool low = cost_low > cost_high || (cost_low == cost_high && inside.low >= last);
    const double choice = low ? inside.low : inside.high;
    if (choice < last) return std::nullopt;
    last = choice;
    sum.add(level.width * std::max(cost_low, cost_high));
  }
  return sum.value();
}

std::size_t stepsOf(const EdgeValues& edges) {
  std::size_t steps = 0;
  for (const EdgeValues::Window& window : edges.windows) steps += window.size();
  return steps;
}

double bestOf(const std::vector<EdgeLevel>& levels, const EdgeValues& edges) {
  // best[i]: largest sum so far whose last quantile is <= values[i]. Entries above `reached` are not yet written: no
  // level had its quantile there, so they equal best[reached].
  std::vector<double> best(edges.values.size(), 0.0);
  std::size_t reached = 0;
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const auto [first, last] = edges.windows[k];
    if (last > reached) {
      std::fill(best.begin() + static_cast<std::ptrdiff_t>(reached) + 1,
                best.begin() + static_cast<std::ptrdiff_t>(last) + 1, best[reached]);
      reached = last;
    }
    double largest = -std::numeric_limits<double>::infinity();
    const EdgeLevel level = levels[k];
    for (std::size_t i = first; i <= last; ++i) {
      largest = std::max(largest, best[i] + level.width * costOf(level, edges.values[i]));
      best[i] = largest;
    }
  }
  return best[reached];
}

}  // namespace

LargestArea largestAreaMetric(const Comparison& boxes, std::size_t limit) {
  if (boxes.simulated.isSingleDistribution()) return {.area = areaValidationMetric(boxes), .error = 0.0};
  std::vector<EdgeLevel> levels = edgeLevels(boxes);
  if (const auto area = levelByLevel(levels)) return {.area = *area, .error = 0.0};
  const RoundedLevels search = finestAffordable(std::move(levels), [limit](const std::vector<EdgeLevel>& candidate) {
    return stepsOf(edgeValues(candidate, &EdgeLevel::simulated)) <= limit;
  });
  return {.area = bestOf(search.levels, edgeValues(search.levels, &EdgeLevel::simulated)), .error = search.grid};
}

}  // namespace metrics
