#include "metrics/area/area_range.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "metrics/area/area_metric.h"
#include "metrics/area/edge_levels.h"
#include "metrics/area/largest_area_metric.h"
#include "metrics/distributions/summation.h"

namespace metrics {

namespace {

constexpr double kNothingYet = -std::numeric_limits<double>::infinity();

struct Quantiles {
  double simulated = kNothingYet;
  double measured = kNothingYet;

  [[nodiscard]] double distance() const { return std::abs(simulated - measured); }
  [[nodiscard]] bool mayFollow(const Quantiles& last) const {
    return simulated >= last.simulated && measured >= last.measured;
  }
};

/// The larger distance at every level, if these choices rise as quantiles must.
std::optional<double> levelByLevel(const std::vector<EdgeLevel>& levels) {
  Summation sum;
  Quantiles last;
  for (const EdgeLevel& level : levels) {
    Quantiles farther{.simulated = level.simulated.high, .measured = level.measured.low};
    Quantiles other{.simulated = level.simulated.low, .measured = level.measured.high};
    if (other.distance() > farther.distance()) std::swap(farther, other);
    if (!farther.mayFollow(last) && other.distance() == farther.distance()) std::swap(farther, other);
    if (!farther.mayFollow(last)) return std::nullopt;
    last = farther;
    sum.add(level.width * farther.distance());
  }
  return sum.value();
}

/// Pairs of edge values that a level permits, with the largest sum up to it whose quantiles are not above the pair.
class Sums {
 public:
  using Window = EdgeValues::Window;

  Sums(const Window& simulated, const Window& measured)
      : simulated_(simulated), measured_(measured), sums_(simulated.size() * measured.size(), 0.0) {}

  double& at(std::size_t i, std::size_t j) {
    return sums_[(i - simulated_.first) * measured_.size() + (j - measured_.first)];
  }
  /// Beyond the windows no larger quantile was possible: the last one within counts.
  double upTo(std::size_t i, std::size_t j) { return at(std::min(i, simulated_.last), std::min(j, measured_.last)); }

 private:
  Window simulated_;
  Window measured_;
  std::vector<double> sums_;
};

double bestOf(const std::vector<EdgeLevel>& levels) {
  const EdgeValues simulated = edgeValues(levels, &EdgeLevel::simulated);
  const EdgeValues measured = edgeValues(levels, &EdgeLevel::measured);
  Sums before({.first = 0, .last = 0}, {.first = 0, .last = 0});
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const auto [first_i, last_i] = simulated.windows[k];
    const auto [first_j, last_j] = measured.windows[k];
    Sums here(simulated.windows[k], measured.windows[k]);
    for (std::size_t i = first_i; i <= last_i; ++i) {
      for (std::size_t j = first_j; j <= last_j; ++j) {
        const double distance = std::abs(simulated.values[i] - measured.values[j]);
        double largest = before.upTo(i, j) + levels[k].width * distance;
        if (i > first_i) largest = std::max(largest, here.at(i - 1, j));
        if (j > first_j) largest = std::max(largest, here.at(i, j - 1));
        here.at(i, j) = largest;
      }
    }
    before = std::move(here);
  }
  return before.at(simulated.windows.back().last, measured.windows.back().last);
}

bool isAffordable(const std::vector<EdgeLevel>& levels, std::size_t limit) {
  const EdgeValues simulated = edgeValues(levels, &EdgeLevel::simulated);
  const EdgeValues measured = edgeValues(levels, &EdgeLevel::measured);
  std::size_t steps = 0;
  for (std::size_t k = 0; k < levels.size() && steps <= limit; ++k) {
    steps += simulated.windows[k].size() * measured.windows[k].size();
  }
  return steps <= limit;
}

LargestArea largestOfPairs(const Comparison& boxes, std::size_t limit) {
  if (boxes.measured.isSingleDistribution()) return largestAreaMetric(boxes, limit);
  if (boxes.simulated.isSingleDistribution()) {
    return largestAreaMetric({.simulated = boxes.measured, .measured = boxes.simulated}, limit);
  }
  std::vector<EdgeLevel> levels = edgeLevels(boxes);
  if (const auto area = levelByLevel(levels)) return {.area = *area, .error = 0.0};
  const auto affordable = [limit](const std::vector<EdgeLevel>& candidate) { return isAffordable(candidate, limit); };
  const RoundedLevels search = finestAffordable(std::move(levels), affordable);
  return {.area = bestOf(search.levels), .error = search.grid};
}

}  // namespace

AreaRange areaRange(const Comparison& boxes, std::size_t limit) {
  const LargestArea largest = largestOfPairs(boxes, limit);
  return {.smallest = areaValidationMetric(boxes), .largest = largest.area, .error = largest.error};
}

}  // namespace metrics
