#pragma once

#include "metrics/distributions/comparison.h"

namespace metrics {

/// Simulated minus measured, each in the unit of the measurand; > 0: simulation too high or too wide.
/// Medians are halfway between the two middle values of an even sample; standard deviations have n - 1 in the
/// denominator and are NaN for fewer than two values.
[[nodiscard]] double meanDifference(const SamplePair& samples);
[[nodiscard]] double medianDifference(const SamplePair& samples);
[[nodiscard]] double standardDeviationDifference(const SamplePair& samples);

}  // namespace metrics
