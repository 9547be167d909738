#pragma once

#include <cstddef>
#include <span>

#include "metrics/distributions/comparison.h"

namespace metrics {

/// A smaller sample does not count: the asymptotic p-value is not to be trusted below.
inline constexpr double kSmallestKsSample = 12.0;

struct PositiveKsTests {
  double frequency;        ///< rejected / counted, in [0, 1]; best near alpha or below; NaN if no pair counted
  std::size_t rejected;    ///< pairs with p <= alpha: "positive", the samples differ
  std::size_t counted;     ///< pairs of two large enough samples
  std::size_t too_small;   ///< pairs left out: n or m (effective, if weighted) below 12, or no sample at all
  std::size_t heavy_ties;  ///< counted pairs whose p-value suffers from ties: too few rejections
};

/// How often a Kolmogorov-Smirnov test tells simulation and measurement apart, over many pairs of samples (one a
/// scenario, object or gate). If every pair came from one distribution a share of alpha would still be rejected.
///
///   sum_k [p_k <= alpha] / K
///
/// Throws InputError unless 0 < alpha < 1. Number 33 in Rosenberger 2022, Tab. 4-3; p-values after Stephens 1970, as in
/// kolmogorovSmirnovTest.
[[nodiscard]] PositiveKsTests positiveKsTests(std::span<const SamplePair> pairs, double alpha = 0.05);

}  // namespace metrics
