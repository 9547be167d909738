#pragma once

#include "metrics/distributions/comparison.h"

namespace metrics {

struct KolmogorovSmirnov {
  double statistic;  ///< largest vertical distance of the two CDFs, in [0, 1]
  double p_value;    ///< chance of at least this distance if both samples come from one continuous distribution
};

/// Two-sample Kolmogorov-Smirnov test. The p-value is asymptotic with Stephens' correction, as in MATLAB's kstest2:
///
///   N = n m / (n + m),  lambda = (sqrt(N) + 0.12 + 0.11 / sqrt(N)) D,  p = 2 sum_j (-1)^(j-1) exp(-2 j^2 lambda^2)
///
/// It assumes a continuous measurand: with ties (counters of 1 cm, pulse widths of 4 cm) it is too large. It is NaN for
/// functions without a sample size. Weighted samples count with their effective size.
/// Source: Stephens 1970, doi:10.1111/j.2517-6161.1970.tb00821.x.
[[nodiscard]] KolmogorovSmirnov kolmogorovSmirnovTest(const SamplePair& samples);

}  // namespace metrics
