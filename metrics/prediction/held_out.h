#pragma once

#include <cstddef>

#include "metrics/distributions/interval.h"
#include "metrics/prediction/error_samples.h"
#include "metrics/prediction/prediction.h"

namespace metrics {

/// How a prediction did on samples that it was not made from. A miss is the sample's error minus the predicted one.
struct HeldOutCheck {
  std::size_t n = 0;
  std::size_t covered = 0;       ///< samples inside their observation interval
  std::size_t extrapolated = 0;  ///< of all n
  Interval coverage;             ///< of the share covered: Clopper-Pearson at the prediction's own level
  double mean_miss = 0.0;
  double mean_absolute_miss = 0.0;
  double largest_miss = 0.0;         ///< with its sign
  std::size_t largest_miss_row = 0;  ///< index in the samples
  /// Share of the squared error that the prediction takes away: 1 - sum miss^2 / sum (error - other)^2. 1 is perfect,
  /// below 0 worse than the other. NaN if there the other misses nothing.
  double skill_over_none = 0.0;  ///< other: 0, the simulation is taken as right
  double skill_over_mean = 0.0;  ///< other: the mean error of the samples the prediction was made from

  [[nodiscard]] double share() const noexcept { return static_cast<double>(covered) / static_cast<double>(n); }
  /// The promised level is credible: it lies inside `coverage`.
  [[nodiscard]] bool holds(const Prediction& prediction) const noexcept { return coverage.contains(prediction.level); }
};

/// Throws InputError if the samples are bad or have other parameters, in name or order.
/// Source: Clopper & Pearson 1934, doi:10.1093/biomet/26.4.404; skill as in Murphy 1988, Mon. Weather Rev. 116.
[[nodiscard]] HeldOutCheck checkHeldOut(const Prediction& prediction, const ErrorSamples& held_out);

}  // namespace metrics
