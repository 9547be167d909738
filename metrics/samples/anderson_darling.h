#pragma once

#include <cstddef>
#include <cstdint>

#include "metrics/distributions/comparison.h"

namespace metrics {

struct AndersonDarling {
  double statistic;     ///< A^2 >= 0, near 1 if both samples come from one distribution
  double standardised;  ///< (A^2 - 1) / standard deviation of A^2: what the tables of the k-sample test list
  double p_value;       ///< chance of at least this A^2 if both samples come from one distribution
};

/// Two-sample Anderson-Darling test: squared distance of the two CDFs, weighted so that the tails count as much as the
/// middle. In the mid-rank form ties share their rank; at a value x of the pooled N = n + m
///
///   M_i = values of sample i below x + half of those at x;  B = M_1 + M_2;  l = pooled values at x
///   A^2 = (N - 1)/N  sum_i 1/n_i  sum_x  l/N  (N M_i - n_i B)^2 / (B (N - B) - N l/4)
///
/// The p-value is that of the limit distribution (k = 2: sum of chi^2_j / (j (j + 1)), evaluated to rounding error, not
/// read off the table of seven percentiles), at the standardised statistic, i.e. corrected for finite N by the exact
/// variance of A^2 without ties. It is NaN for fewer than four values, equal ones only, or functions without a sample
/// size. Weighted samples count with their effective size.
/// Source: Scholz & Stephens 1987, doi:10.1080/01621459.1987.10478517 (statistic A^2_akN, variance);
/// Anderson & Darling 1952, doi:10.1214/aoms/1177729437 (limit).
[[nodiscard]] AndersonDarling andersonDarlingTest(const SamplePair& samples);

/// The same, with the p-value (1 + shuffles of the labels with at least this A^2) / (1 + shuffles): right for few
/// values and for ties, never below 1 / (1 + shuffles). Equal seeds give equal results. Throws InputError for weighted
/// samples or functions without a sample, and for 0 shuffles.
[[nodiscard]] AndersonDarling andersonDarlingPermutationTest(const SamplePair& samples, std::uint32_t shuffles = 999,
                                                             std::uint64_t seed = 1);

/// Chance that the limit of A^2 exceeds z, with full relative accuracy in the tail. Also the limit of the one-sample
/// statistic against a given distribution.
[[nodiscard]] double andersonDarlingTail(double z);

struct Normal {
  double mean;
  double deviation;  ///< > 0
};

struct AndersonDarlingToNormal {
  double statistic;         ///< from logarithms of both tails; always finite
  double as_published;      ///< from log(1 - cdf): infinite once 1 - cdf rounds to 0
  std::size_t rounded_off;  ///< distinct values that make it so: more than about 8.29 deviations above the mean
};

/// One-sample Anderson-Darling distance of a sample to a normal distribution. With heights P of the EDF after its
/// values x, and u = cdf(x):
///
///   A^2 = -n (1 + sum (P_i^2 - P_{i-1}^2) log u_i + ((1 - P_{i-1})^2 - (1 - P_i)^2) log(1 - u_i))
///
/// Unweighted and without ties this is the textbook form; no p-value is given, since the tables hold for a normal that
/// is known or fitted to the same sample, not for one fitted to another.
///
/// Why infinities are published: a double near 1 has a spacing of 1.1e-16, so 1 - cdf is 0 from 8.29 deviations above
/// the mean and its logarithm infinite. Below the mean the same distance does no harm: there cdf itself is small and
/// exact. Here log(1 - cdf) is computed from the upper tail.
/// Throws InputError unless the deviation is positive and finite. Source: Anderson & Darling 1954, doi:10.2307/2281537.
[[nodiscard]] AndersonDarlingToNormal andersonDarlingToNormal(const Edf& sample, const Normal& normal);

/// The simulated sample against the normal fitted to the measured one (mean, standard deviation with n - 1): the D_AD
/// of Rosenberger 2022, Tab. 8-4. Not symmetric. Throws InputError if the measured sample has no spread.
[[nodiscard]] AndersonDarlingToNormal andersonDarlingToFittedNormal(const SamplePair& samples);

}  // namespace metrics
