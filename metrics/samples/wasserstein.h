#pragma once

#include "metrics/distributions/comparison.h"

namespace metrics {

/// 1-Wasserstein distance of two samples, int |F(x) - G(x)| dx, summed along the values (the area metric sums the same
/// area along the levels). >= 0. [unit of the measurand]
/// Source: Vallender 1974, doi:10.1137/1118101.
[[nodiscard]] double wassersteinDistance(const SamplePair& samples);

}  // namespace metrics
