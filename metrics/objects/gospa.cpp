#include "metrics/objects/gospa.h"

#include <algorithm>
#include <cmath>

#include "metrics/distributions/summation.h"

namespace metrics {

Gospa gospa(const ObjectLists& lists, const SetOptions& options) {
  mustBeValid(lists);
  mustBeValid(options);
  const CostTable distances = positionDistances(lists);
  // Cut off, the assignment may pair everything: a pair at c costs what its two objects cost alone.
  const CostTable costs(distances.rows(), distances.columns(), [&](std::size_t i, std::size_t j) {
    return std::pow(std::min(distances(i, j), options.cutoff_m), options.order);
  });
  const auto partner = optimalAssignment(costs);
  Gospa result{};
  Summation sum;
  for (std::size_t i = 0; i < partner.size(); ++i) {
    if (!partner[i] || distances(i, *partner[i]) >= options.cutoff_m) continue;
    result.pairs.push_back({.measured = i, .simulated = *partner[i]});
    sum.add(costs(i, *partner[i]));
  }
  result.missed = lists.measured.size() - result.pairs.size();
  result.false_objects = lists.simulated.size() - result.pairs.size();
  const double alone = 0.5 * std::pow(options.cutoff_m, options.order);
  const double rest = alone * static_cast<double>(result.missed + result.false_objects);
  result.localisation = std::pow(sum.value(), 1.0 / options.order);
  result.distance = std::pow(sum.value() + rest, 1.0 / options.order);
  return result;
}

}  // namespace metrics
