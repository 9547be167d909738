#include "metrics/area/edge_levels.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "metrics/distributions/level_walk.h"

namespace metrics {

namespace {

double rangeOf(const std::vector<EdgeLevel>& levels) {
  return std::max(levels.back().simulated.high, levels.back().measured.high) -
         std::min(levels.front().simulated.low, levels.front().measured.low);
}

std::vector<EdgeLevel> rounded(const std::vector<EdgeLevel>& levels, double grid) {
  const auto round = [grid](const Interval& x) {
    return Interval{.low = grid * std::round(x.low / grid), .high = grid * std::round(x.high / grid)};
  };
  std::vector<EdgeLevel> result;
  for (const EdgeLevel& level : levels) {
    const EdgeLevel coarse{
        .width = level.width, .simulated = round(level.simulated), .measured = round(level.measured)};
    if (!result.empty() && result.back().simulated == coarse.simulated && result.back().measured == coarse.measured) {
      result.back().width += coarse.width;
    } else {
      result.push_back(coarse);
    }
  }
  return result;
}

}  // namespace

std::vector<EdgeLevel> edgeLevels(const Comparison& boxes) {
  std::vector<EdgeLevel> levels;
  eachCommonLevel<4>(
      {&boxes.simulated.left(), &boxes.simulated.right(), &boxes.measured.left(), &boxes.measured.right()},
      [&](const CommonLevel<4>& at) {
        levels.push_back({.width = at.width(),
                          .simulated = {.low = at.quantiles[0], .high = at.quantiles[1]},
                          .measured = {.low = at.quantiles[2], .high = at.quantiles[3]}});
      });
  return levels;
}

EdgeValues edgeValues(const std::vector<EdgeLevel>& levels, Interval EdgeLevel::*box) {
  std::vector<double> low;
  std::vector<double> high;
  for (const EdgeLevel& level : levels) {
    const Interval& inside = level.*box;
    if (low.empty() || low.back() != inside.low) low.push_back(inside.low);
    if (high.empty() || high.back() != inside.high) high.push_back(inside.high);
  }
  EdgeValues edges;
  std::set_union(low.begin(), low.end(), high.begin(), high.end(), std::back_inserter(edges.values));
  EdgeValues::Window window{.first = 0, .last = 0};
  for (const EdgeLevel& level : levels) {
    while (edges.values[window.first] < (level.*box).low) ++window.first;
    while (edges.values[window.last] < (level.*box).high) ++window.last;
    edges.windows.push_back(window);
  }
  return edges;
}

RoundedLevels finestAffordable(std::vector<EdgeLevel> levels,
                               const std::function<bool(const std::vector<EdgeLevel>&)>& affordable) {
  if (affordable(levels)) return {.levels = std::move(levels), .grid = 0.0};
  const double range = rangeOf(levels);
  double grid = range / static_cast<double>(1 << 20);
  std::vector<EdgeLevel> coarse = rounded(levels, grid);
  while (!affordable(coarse) && grid < range) {
    grid *= 2.0;
    coarse = rounded(levels, grid);
  }
  return {.levels = std::move(coarse), .grid = grid};
}

}  // namespace metrics
