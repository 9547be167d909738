#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "metrics/distributions/edf.h"

namespace metrics {

/// Visits, in ascending order, every value at which either function steps, with the heights of both after the step:
/// visit(x, height of a, height of b). Linear in the number of steps, and without branches that chance decides.
template <typename Visit>
void eachCommonValue(const Edf& a, const Edf& b, Visit&& visit) {
  const std::span<const double> x = a.values();
  const std::span<const double> y = b.values();
  const auto height = [](const Edf& edf, std::size_t steps) { return steps == 0 ? 0.0 : edf.level(steps - 1); };
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < x.size() && j < y.size()) {
    const double left = x[i];
    const double right = y[j];
    i += left <= right ? 1 : 0;
    j += right <= left ? 1 : 0;
    visit(std::min(left, right), height(a, i), height(b, j));
  }
  for (; i < x.size(); ++i) visit(x[i], a.level(i), 1.0);
  for (; j < y.size(); ++j) visit(y[j], 1.0, b.level(j));
}

}  // namespace metrics
