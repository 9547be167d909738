#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "metrics/distributions/edf.h"

namespace metrics {

/// Edf::level for inner loops: where to look is looked up once.
class LevelOf {
 public:
  explicit LevelOf(const Edf& edf)
      : stored_(edf.hasEqualSteps() ? nullptr : edf.levels().data()), n_(static_cast<double>(edf.values().size())) {}

  double operator()(std::size_t i) const noexcept {
    return stored_ != nullptr ? stored_[i] : static_cast<double>(static_cast<std::int64_t>(i + 1)) / n_;
  }

 private:
  const double* stored_;  // none: equal steps
  double n_;
};

/// Visits, in ascending order, every value at which either function steps, with the heights of both after the step:
/// visit(x, height of a, height of b). Linear in the number of steps, and without a branch that chance decides.
template <typename Visit>
void eachCommonValue(const Edf& a, const Edf& b, Visit&& visit) {
  const std::span<const double> x = a.values();
  const std::span<const double> y = b.values();
  const LevelOf level_a(a);
  const LevelOf level_b(b);
  std::size_t i = 0;
  std::size_t j = 0;
  for (; i < x.size() && x[i] < y[0]; ++i) visit(x[i], level_a(i), 0.0);
  for (; j < y.size() && y[j] < x[0]; ++j) visit(y[j], 0.0, level_b(j));
  while (i < x.size() && j < y.size()) {  // both have stepped, or do so now
    const double left = x[i];
    const double right = y[j];
    i += static_cast<std::size_t>(left <= right);
    j += static_cast<std::size_t>(right <= left);
    visit(std::min(left, right), level_a(i - 1), level_b(j - 1));
  }
  for (; i < x.size(); ++i) visit(x[i], level_a(i), 1.0);
  for (; j < y.size(); ++j) visit(y[j], 1.0, level_b(j));
}

}  // namespace metrics
