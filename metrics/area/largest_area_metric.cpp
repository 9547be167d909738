#include "metrics/area/largest_area_metric.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <vector>

#include "metrics/area/area_metric.h"
#include "metrics/distributions/level_walk.h"
#include "metrics/distributions/summation.h"

namespace metrics {

namespace {

/// A stretch of probability on which all edges are constant.
struct Level {
  double width;
  double low, high;            // the simulated quantile may lie in [low, high]
  double real_low, real_high;  // the measured box

  [[nodiscard]] double cost(double q) const { return std::max(0.0, std::max(real_low - q, q - real_high)); }
  [[nodiscard]] bool sameValues(const Level& other) const {
    return low == other.low && high == other.high && real_low == other.real_low && real_high == other.real_high;
  }
};

std::vector<Level> levelsOf(const Comparison& boxes) {
  std::vector<Level> levels;
  eachCommonLevel<4>(
      {&boxes.simulated.left(), &boxes.simulated.right(), &boxes.measured.left(), &boxes.measured.right()},
      [&](const CommonLevel<4>& at) {
        levels.push_back({.width = at.width(),
                          .low = at.quantiles[0],
                          .high = at.quantiles[1],
                          .real_low = at.quantiles[2],
                          .real_high = at.quantiles[3]});
      });
  return levels;
}

/// The larger cost at every level, if these choices rise as quantiles must.
std::optional<double> levelByLevel(const std::vector<Level>& levels) {
  Summation sum;
  double last = -std::numeric_limits<double>::infinity();
  for (const Level& level : levels) {
    const double cost_low = level.cost(level.low);
    const double cost_high = level.cost(level.high);
    const bool low = cost_low > cost_high || (cost_low == cost_high && level.low >= last);
    const double choice = low ? level.low : level.high;
    if (choice < last) return std::nullopt;
    last = choice;
    sum.add(level.width * std::max(cost_low, cost_high));
  }
  return sum.value();
}

std::vector<Level> rounded(const std::vector<Level>& levels, double grid) {
  const auto round = [grid](double x) { return grid * std::round(x / grid); };
  std::vector<Level> result;
  for (const Level& level : levels) {
    const Level coarse{.width = level.width,
                       .low = round(level.low),
                       .high = round(level.high),
                       .real_low = round(level.real_low),
                       .real_high = round(level.real_high)};
    if (!result.empty() && result.back().sameValues(coarse)) {
      result.back().width += coarse.width;
    } else {
      result.push_back(coarse);
    }
  }
  return result;
}

/// The values of both edges, ascending, and for every level which of them lie inside the box.
struct Search {
  struct Window {
    std::size_t first, last;  // inclusive
  };
  std::vector<double> values;
  std::vector<Window> windows;
  std::size_t steps = 0;
};

Search searchOver(const std::vector<Level>& levels) {
  std::vector<double> low;
  std::vector<double> high;
  for (const Level& level : levels) {
    if (low.empty() || low.back() != level.low) low.push_back(level.low);
    if (high.empty() || high.back() != level.high) high.push_back(level.high);
  }
  Search search;
  std::set_union(low.begin(), low.end(), high.begin(), high.end(), std::back_inserter(search.values));
  Search::Window window{0, 0};
  for (const Level& level : levels) {
    while (search.values[window.first] < level.low) ++window.first;
    while (search.values[window.last] < level.high) ++window.last;
    search.windows.push_back(window);
    search.steps += window.last - window.first + 1;
  }
  return search;
}

double bestOf(const std::vector<Level>& levels, const Search& search) {
  // best[i]: largest sum so far whose last quantile is <= values[i]. Entries above `reached` are not yet written: no
  // level had its quantile there, so they equal best[reached].
  std::vector<double> best(search.values.size(), 0.0);
  std::size_t reached = 0;
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const auto [first, last] = search.windows[k];
    if (last > reached) {
      std::fill(best.begin() + static_cast<std::ptrdiff_t>(reached) + 1,
                best.begin() + static_cast<std::ptrdiff_t>(last) + 1, best[reached]);
      reached = last;
    }
    double largest = -std::numeric_limits<double>::infinity();
    const Level level = levels[k];
    for (std::size_t i = first; i <= last; ++i) {
      largest = std::max(largest, best[i] + level.width * level.cost(search.values[i]));
      best[i] = largest;
    }
  }
  return best[reached];
}

double rangeOf(const std::vector<Level>& levels) {
  return std::max(levels.back().high, levels.back().real_high) - std::min(levels.front().low, levels.front().real_low);
}

}  // namespace

LargestArea largestAreaMetric(const Comparison& boxes, std::size_t limit) {
  if (boxes.simulated.isSingleDistribution()) return {.area = areaValidationMetric(boxes), .error = 0.0};
  const std::vector<Level> levels = levelsOf(boxes);
  if (const auto area = levelByLevel(levels)) return {.area = *area, .error = 0.0};
  Search search = searchOver(levels);
  if (search.steps <= limit) return {.area = bestOf(levels, search), .error = 0.0};

  double grid = rangeOf(levels) / static_cast<double>(1 << 20);
  std::vector<Level> coarse = rounded(levels, grid);
  for (search = searchOver(coarse); search.steps > limit && search.values.size() > 2; search = searchOver(coarse)) {
    grid *= 2.0;
    coarse = rounded(levels, grid);
  }
  return {.area = bestOf(coarse, search), .error = grid};
}

}  // namespace metrics
