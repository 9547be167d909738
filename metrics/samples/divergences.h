#pragma once

#include <cstddef>
#include <span>

#include "metrics/distributions/comparison.h"

namespace metrics {

enum class InformationUnit { Bit, Nat };

/// Two vectors of probabilities (or counts, or densities on one equidistant grid) over the same cells.
struct Probabilities {
  std::span<const double> simulated;
  std::span<const double> measured;
};

/// How differently two distributions fill the same cells. p measured, q simulated, m = (p + q)/2; all >= 0.
struct Divergences {
  double kl;           ///< D(p||q) = sum p log(p/q): infinite where something was measured but never simulated
  double kl_reverse;   ///< D(q||p): infinite where something was simulated but never measured
  double symmetrised;  ///< (D(p||q) + D(q||p)) / 2, half of Jeffreys' divergence
  double js;           ///< Jensen-Shannon divergence (D(p||m) + D(q||m)) / 2, in [0, 1 bit]
  double js_distance;  ///< its square root: obeys the triangle inequality
};

/// Kullback-Leibler and Jensen-Shannon divergences of discrete distributions. Both vectors are normalised to sum 1.
///
///   measured  |#|#|#| |       cell 3: measured, not simulated -> D(p||q) = inf
///   simulated |#|#| |#|       cell 4: simulated, not measured -> D(q||p) = inf; JS stays finite
///
/// The trap: summing over cells that both fill hides the infinity and may even turn negative, since the terms left out
/// are those that keep the sum above 0. Not done here.
/// Throws InputError if the lengths differ, a number is negative or not finite, or a vector has no positive one.
/// Source: Kullback & Leibler 1951, doi:10.1214/aoms/1177729694; Lin 1991, doi:10.1109/18.61115; distance: Endres &
/// Schindelin 2003, doi:10.1109/TIT.2003.813506.
[[nodiscard]] Divergences divergences(const Probabilities& cells, InformationUnit unit = InformationUnit::Bit);

/// Of two samples by counting in bins [edge_i, edge_i+1), the last one closed. The result depends on the bins, and
/// a bin that one sample leaves empty makes a divergence infinite: state the edges. [edges in the unit of x]
/// Throws InputError unless the edges rise strictly and hold every value: nothing is dropped silently.
[[nodiscard]] Divergences histogramDivergences(const SamplePair& samples, std::span<const double> edges,
                                               InformationUnit unit = InformationUnit::Bit);

/// Bandwidth of a Gaussian kernel, h = 1.06 MAD / 0.6745 n^(-1/5), with MAD the median distance from the median: the
/// rule for a normal density with a spread that outliers do not move. 0 if more than half of the values are equal, NaN
/// for functions without a sample size. [unit of x] Source: Silverman 1986, doi:10.1201/9781315140919, sec. 3.4.
[[nodiscard]] double kdeBandwidth(const Edf& sample);

/// Of two samples through Gaussian kernel densities f(x) = sum w_i phi((x - x_i)/h) / h, each with its own bandwidth,
/// read at `points` equidistant places that reach 3 bandwidths beyond either sample, and normalised to sum 1. (More
/// places where these would be further apart than the smaller bandwidth, as with an outlier.)
///
/// This estimator, with 100 points, reproduces Rosenberger 2022, Tab. 8-5, which names none (docs/metrics-chapter8.md).
/// Smooth kernels never end: what looks like missing support is a far tail of the kernel, so D(q||p) is large and moves
/// with the bandwidth; it is infinite only where the density underflows (38 bandwidths away).
/// Throws InputError if a bandwidth is not positive (counters with heavy ties: count in bins instead), values
/// spread over more than 10^6 bandwidths, or points < 2.
[[nodiscard]] Divergences kdeDivergences(const SamplePair& samples, InformationUnit unit = InformationUnit::Bit,
                                         std::size_t points = 100);

}  // namespace metrics
