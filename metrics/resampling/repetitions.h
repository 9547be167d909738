#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/progress.h"
#include "metrics/resampling/bootstrap.h"

namespace metrics {

/// How often to repeat (frames, set-ups) until an interval is as narrow as wanted. A pilot knows its scatter only so
/// well: `low` and `high` say how well.
struct Repetitions {
  double factor;  ///< on the pilot's number of units; below 1: the pilot was more than enough
  double low;     ///< interval of the factor
  double high;

  /// Units needed where the pilot had `pilot`; at least 2.
  [[nodiscard]] std::size_t of(std::size_t pilot) const;
};

/// For the mean of normally distributed units, in closed form:
///
///   n = (z s / w)^2,   z normal quantile of the confidence, s standard deviation of the pilot, w wanted half width
///
/// with the chi-squared interval of s. Throws InputError if the pilot has fewer than two values or one that is not
/// finite, or unless half_width > 0 and 0 < confidence < 1.
/// Source: Snedecor & Cochran 1989, Statistical Methods.
[[nodiscard]] Repetitions repetitionsForMean(std::span<const double> pilot, double half_width, double confidence);

/// For any figure of a comparison: the width of its bootstrap interval falls as 1/sqrt(number of units) if all sides
/// grow by one factor. True of d_bias; of d_avm and d_cavm while they are clear of their floor.
struct FigureRepetitions {
  Repetitions repetitions;
  ConfidenceInterval pilot;  ///< interval of the figure that the pilot gives
  double measured_share;     ///< of the variance that the measured units bring: where repeating helps; NaN if paired
};

/// One result a figure; half_widths[f] is wanted of figure f. The uncertainty of a width follows from how unevenly the
/// groups of the jackknife share in it: chi-squared with Satterthwaite's degrees of freedom 2 V^2 / Var V for
/// V = sum D^2, never more than groups - 1 a side (our choice).
/// Throws InputError as bootstrapIntervals does, or unless every half width is > 0.
/// Source: Satterthwaite 1946, doi:10.2307/3002019; D: bcaInterval.
[[nodiscard]] std::vector<FigureRepetitions> repetitionsForFigures(const UnitComparison& samples,
                                                                   std::span<const double> half_widths,
                                                                   const Figures& figures,
                                                                   const BootstrapOptions& options,
                                                                   core::Progress& progress);

}  // namespace metrics
