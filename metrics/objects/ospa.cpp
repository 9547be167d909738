#include "metrics/objects/ospa.h"

#include <algorithm>
#include <cmath>

#include "metrics/distributions/summation.h"

namespace metrics {

Ospa ospa(const CostTable& distances, const SetOptions& options) {
  mustBeValid(options);
  const auto [fewer, more] = std::minmax({distances.rows(), distances.columns()});
  if (more == 0) return {};
  const CostTable costs(distances.rows(), distances.columns(), [&](std::size_t i, std::size_t j) {
    return std::pow(std::min(distances(i, j), options.cutoff_m), options.order);
  });
  const auto partner = optimalAssignment(costs);
  Summation sum;
  for (std::size_t i = 0; i < partner.size(); ++i) {
    if (partner[i]) sum.add(costs(i, *partner[i]));
  }
  const auto n = static_cast<double>(more);
  const double pairs = sum.value() / n;
  const double unpaired = std::pow(options.cutoff_m, options.order) * static_cast<double>(more - fewer) / n;
  const auto root = [&](double power) { return std::pow(power, 1.0 / options.order); };
  return {.distance = root(pairs + unpaired), .localisation = root(pairs), .cardinality = root(unpaired)};
}

Ospa ospa(const ObjectLists& lists, const SetOptions& options) {
  mustBeValid(lists);
  return ospa(positionDistances(lists), options);
}

}  // namespace metrics
