#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "metrics/distributions/edf.h"

namespace metrics {

/// A stretch of probability, (below, level], on which the quantiles of all functions are constant.
template <std::size_t N>
struct CommonLevel {
  double below;
  double level;
  std::array<double, N> quantiles;  ///< in the order of the functions

  [[nodiscard]] double width() const noexcept { return level - below; }
};

/// Visits the common levels of N step functions from 0 to 1. Linear in the number of steps.
template <std::size_t N, typename Visit>
void eachCommonLevel(const std::array<const Edf*, N>& functions, Visit&& visit) {
  std::array<const double*, N> value;
  std::array<const double*, N> level;
  for (std::size_t k = 0; k < N; ++k) {
    value[k] = functions[k]->values().data();
    level[k] = functions[k]->levels().data();
  }
  CommonLevel<N> here{.below = 0.0, .level = 0.0, .quantiles = {}};
  while (here.level < 1.0) {  // every function ends at exactly 1
    here.below = here.level;
    here.level = *level[0];
    for (std::size_t k = 1; k < N; ++k) here.level = std::min(here.level, *level[k]);
    for (std::size_t k = 0; k < N; ++k) here.quantiles[k] = *value[k];
    visit(here);
    for (std::size_t k = 0; k < N; ++k) {
      const std::size_t done = *level[k] <= here.level ? 1 : 0;
      level[k] += done;
      value[k] += done;
    }
  }
}

}  // namespace metrics
