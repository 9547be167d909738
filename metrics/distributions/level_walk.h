#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "metrics/distributions/edf.h"
#include "metrics/distributions/summation.h"

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

/// Both rise by the same height at every step: their i-th values are their quantiles on the same stretch. Such pairs
/// (samples of one size without ties) need no walk.
[[nodiscard]] inline bool stepTogether(const Edf& a, const Edf& b) noexcept {
  return a.hasEqualSteps() && b.hasEqualSteps() && a.values().size() == b.values().size();
}

/// M integrals over probability, int_0^1 terms(quantile of a, quantile of b) dp; `terms` returns an array of M.
template <std::size_t M, typename Terms>
[[nodiscard]] std::array<double, M> levelIntegrals(const Edf& a, const Edf& b, const Terms& terms) {
  std::array<double, M> integrals;
  if (stepTogether(a, b)) {
    const auto sums = blockSums<M>(a.values().size(), [&terms, x = a.values().data(), y = b.values().data()](
                                                          std::size_t i) { return terms(x[i], y[i]); });
    for (std::size_t m = 0; m < M; ++m) integrals[m] = sums[m] / static_cast<double>(a.values().size());
    return integrals;
  }
  std::array<Summation, M> sums;
  eachCommonLevel<2>({&a, &b}, [&](const CommonLevel<2>& at) {
    const std::array<double, M> term = terms(at.quantiles[0], at.quantiles[1]);
    for (std::size_t m = 0; m < M; ++m) sums[m].add(at.width() * term[m]);
  });
  for (std::size_t m = 0; m < M; ++m) integrals[m] = sums[m].value();
  return integrals;
}

}  // namespace metrics
