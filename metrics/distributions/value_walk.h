#pragma once

#include <algorithm>
#include <cstddef>

#include "metrics/distributions/edf.h"

namespace metrics {

/// Visits, in ascending order, every value at which either function steps, with the heights of both after the step:
/// visit(x, height of a, height of b). Linear in the number of steps.
template <typename Visit>
void eachCommonValue(const Edf& a, const Edf& b, Visit&& visit) {
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.values().size() || j < b.values().size()) {
    const bool a_left = i < a.values().size();
    const bool b_left = j < b.values().size();
    const double x = !b_left ? a.values()[i] : !a_left ? b.values()[j] : std::min(a.values()[i], b.values()[j]);
    if (a_left && a.values()[i] == x) ++i;
    if (b_left && b.values()[j] == x) ++j;
    visit(x, i == 0 ? 0.0 : a.levels()[i - 1], j == 0 ? 0.0 : b.levels()[j - 1]);
  }
}

}  // namespace metrics
