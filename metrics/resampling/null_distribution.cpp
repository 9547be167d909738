#include "metrics/resampling/null_distribution.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "metrics/distributions/summation.h"
#include "metrics/resampling/intervals.h"

namespace metrics {

NullDistribution::NullDistribution(std::vector<double> values) : ascending_(std::move(values)) {
  if (ascending_.empty()) {
    throw core::InputError({.item = "replicates"}, "are none; chance alone is not known.", "Draw 1000 or more.");
  }
  if (!std::ranges::all_of(ascending_, [](double x) { return std::isfinite(x); })) {
    throw core::InputError({}, "a figure is undefined for some replicates; there is no distribution of it.",
                           "Choose a figure that is defined for every sample.");
  }
  std::sort(ascending_.begin(), ascending_.end());
}

double NullDistribution::mean() const noexcept {
  Summation sum;
  for (const double x : ascending_) sum.add(x);
  return sum.value() / static_cast<double>(ascending_.size());
}

double NullDistribution::quantile(double p) const noexcept { return replicateQuantile(ascending_, p); }

double NullDistribution::shareUpTo(double x) const noexcept {
  const auto above = std::upper_bound(ascending_.begin(), ascending_.end(), x);
  return static_cast<double>(above - ascending_.begin()) / static_cast<double>(ascending_.size());
}

double permutationPValue(double observed, const NullDistribution& null) {
  const std::vector<double>& values = null.ascending();
  const auto as_large = values.end() - std::lower_bound(values.begin(), values.end(), observed);
  return (1.0 + static_cast<double>(as_large)) / (1.0 + static_cast<double>(values.size()));
}

}  // namespace metrics
