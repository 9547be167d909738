#pragma once

#include "metrics/distributions/comparison.h"

namespace metrics {

/// How a p-value of the two-sample Kolmogorov-Smirnov test is found.
enum class KsPValue {
  Stephens,     ///< the asymptotic series with Stephens' correction, as in MATLAB's kstest2
  ExactIfSmall  ///< exact while n m <= kExactKsLimit and neither sample is weighted, else Stephens
};

/// Largest n m for an exact p-value: some 40 ms. The asymptotic p-value of larger samples is good to a few per cent.
inline constexpr double kExactKsLimit = 1e7;

struct KolmogorovSmirnov {
  double statistic;  ///< largest vertical distance of the two CDFs, in [0, 1]
  double p_value;    ///< chance of at least this distance if both samples come from one continuous distribution
  KsPValue method;   ///< how the p-value was found
  double tie_share;  ///< share of the pooled values that repeat an earlier one
  bool heavy_ties;   ///< tie_share > 5 % (our choice of limit): the p-value is not to be relied on
};

/// Two-sample Kolmogorov-Smirnov test.
///
///   p 1 |        ____----        D  largest vertical distance
///       |    ___|  ^ D
///     0 |___|______|___
///        ------------------ x  [unit of the measurand]
///
///   Stephens  N = n m / (n + m),  lambda = (sqrt(N) + 0.12 + 0.11 / sqrt(N)) D
///             p = 2 sum_j (-1)^(j-1) exp(-2 j^2 lambda^2)
///   exact     p = share of the lattice paths (0, 0) .. (n, m) that touch |i/n - j/m| >= D: all orders in which
///             n + m distinct values can come are equally likely. Time n m, no cancellation in the tail.
///
/// Both assume a continuous measurand: with ties (counters of 1 cm, pulse widths of 4 cm) they are too large, hence
/// `heavy_ties`. The p-value is NaN for functions without a sample size. Weighted samples count with their effective
/// size.
/// Source: Stephens 1970, doi:10.1111/j.2517-6161.1970.tb00821.x; paths: Hodges 1958, doi:10.1007/BF02589501, as shares
/// after Viehmann 2021, arXiv:2102.08037.
[[nodiscard]] KolmogorovSmirnov kolmogorovSmirnovTest(const SamplePair& samples, KsPValue method = KsPValue::Stephens);

}  // namespace metrics
