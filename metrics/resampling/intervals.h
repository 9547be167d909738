#pragma once

#include <span>

namespace metrics {

/// What a figure of a sample is worth. All but `confidence` in the unit of the figure.
struct ConfidenceInterval {
  double estimate;  ///< of the sample itself
  double low;       ///< low, high: NaN if the figure is undefined for a replicate
  double high;
  double standard_error;  ///< standard deviation of the replicates
  double bias;            ///< mean of the replicates minus estimate: about what the estimate is off the truth
  double confidence;      ///< chance to cover the truth that was asked for

  [[nodiscard]] double width() const noexcept { return high - low; }
};

enum class IntervalMethod {
  Percentile,  ///< the middle `confidence` of the replicates
  BCa          ///< the same, corrected for median bias and for a spread that changes with the truth
};

/// Sample quantile of ascending numbers at rank (B + 1) p, linear between neighbours, never outside of them.
/// Source: Davison & Hinkley 1997, Bootstrap Methods and their Application (rank); Hyndman & Fan 1996,
/// doi:10.2307/2684934 (their type 6).
[[nodiscard]] double replicateQuantile(std::span<const double> ascending, double p);

/// Middle part of the replicates. Throws InputError unless 0 < confidence < 1 and there are two replicates at least.
/// Source: Efron & Tibshirani 1993, An Introduction to the Bootstrap, ch. 13.
[[nodiscard]] ConfidenceInterval percentileInterval(double estimate, std::span<const double> replicates,
                                                    double confidence);

/// Bias-corrected and accelerated interval: percentiles at the levels
///
///   Phi(z0 + (z0 + z) / (1 - a (z0 + z))),   z = Phi^-1((1 -+ confidence) / 2)
///
///   z0 = Phi^-1(share of replicates below the estimate)      a = sum D^3 / (6 (sum D^2)^(3/2))
///
/// `influences` are the D: what each unit, or group of units, moves the figure by (jackknife). Ties of a replicate with
/// the estimate count half; a share of 0 or 1 is moved in by half a replicate, as its z0 would be infinite (our
/// choice). Source: Efron & Tibshirani 1993, eqs. 14.9, 14.10, 14.14, 14.15.
[[nodiscard]] ConfidenceInterval bcaInterval(double estimate, std::span<const double> replicates,
                                             std::span<const double> influences, double confidence);

}  // namespace metrics
