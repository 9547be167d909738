#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "metrics/distributions/comparison.h"
#include "metrics/distributions/interval.h"

namespace metrics {

/// A stretch of probability on which the edges of both boxes are constant: quantiles of distributions inside the boxes
/// lie in these intervals. For searches over all such distributions (largest_area_metric.h, area_range.h).
struct EdgeLevel {
  double width;
  Interval simulated;
  Interval measured;
};

[[nodiscard]] std::vector<EdgeLevel> edgeLevels(const Comparison& boxes);

/// The values of both edges of one box, ascending, and which of them lie inside it at every level.
struct EdgeValues {
  struct Window {
    std::size_t first;
    std::size_t last;  // inclusive

    [[nodiscard]] std::size_t size() const noexcept { return last - first + 1; }
  };
  std::vector<double> values;
  std::vector<Window> windows;  ///< one per level; both ends rise from level to level
};

/// edgeValues(levels, &EdgeLevel::simulated)
[[nodiscard]] EdgeValues edgeValues(const std::vector<EdgeLevel>& levels, Interval EdgeLevel::*box);

/// Levels whose values were rounded to multiples of `grid`; no value moved by more than half of it. 0: not rounded.
struct RoundedLevels {
  std::vector<EdgeLevel> levels;
  double grid;
};

/// The levels as they are if a search can afford them, else rounded to the finest grid for which it can (among the
/// range of all values divided by powers of two).
[[nodiscard]] RoundedLevels finestAffordable(std::vector<EdgeLevel> levels,
                                             const std::function<bool(const std::vector<EdgeLevel>&)>& affordable);

}  // namespace metrics
