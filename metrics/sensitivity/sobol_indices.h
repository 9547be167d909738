#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "metrics/sensitivity/sensitivity_indices.h"

namespace metrics {

/// How the first-order index is estimated. The total one is Jansen's in both cases.
enum class FirstOrderEstimator {
  Saltelli,  ///< V_i = mean f_B (f_ABi - f_A)
  Jansen     ///< V_i = V - mean (f_B - f_ABi)^2 / 2
};

struct SobolOptions {
  FirstOrderEstimator first_order = FirstOrderEstimator::Saltelli;
  std::size_t replicates = 1000;  ///< of the bootstrap; 0: no intervals
  double confidence = 0.95;
  std::uint64_t seed = 1;
};

/// Sobol' indices of one output, given row by row of sobolPlan(k parameters, n):
///
///   S_i = V_i / V        S_Ti = mean (f_A - f_ABi)^2 / (2 V)        V variance of f_A and f_B together
///
/// Outputs are centred first: Saltelli's estimator loses digits to a large mean. Intervals are percentiles of a
/// bootstrap over the n rows, which takes them for random; the points lie more evenly than that, so intervals are
/// rather too wide. For a small S_i Saltelli's estimator is the better one, for a large one Jansen's.
/// A library (OpenTURNS 1.20) was looked at: it brings 18 packages for these few lines, and wants to own the plan.
/// Throws InputError unless there are n (k + 2) finite outputs, k > 0, n > 1.
/// Source: Saltelli et al. 2010, doi:10.1016/j.cpc.2009.09.018, table 2 (b), (c), (f); Jansen 1999,
/// doi:10.1016/S0010-4655(98)00154-4; bootstrap: Archer, Saltelli & Sobol' 1997, doi:10.1080/00949659708811825.
[[nodiscard]] SensitivityResult sobolIndices(std::span<const double> outputs, std::size_t parameters, std::size_t n,
                                             const SobolOptions& options = {});

}  // namespace metrics
