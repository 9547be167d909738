#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "metrics/distributions/interval.h"
#include "metrics/prediction/regression.h"

namespace metrics {

/// The error that a simulation has at one point of its parameters, as far as validation tells.
struct PredictedError {
  double value;                ///< [unit of the measurand]
  Interval confidence;         ///< of the mean error at this point
  Interval observation;        ///< of the error of one more sample of average weight there: wider
  std::uint32_t outside = 0;   ///< bit k: parameter k lies outside the range of the samples
  bool outside_joint = false;  ///< every parameter is in range, but their combination is far from all samples

  [[nodiscard]] bool extrapolated() const noexcept { return outside != 0 || outside_joint; }
  /// The bound of the confidence interval with the largest magnitude: what the published tables print in brackets.
  [[nodiscard]] double largest() const noexcept;
};

/// Where samples were. Inside is interpolation.
///
///   outside_joint:  h1(x) > max over samples of h1,   h1 = leverage of the linear family, weights aside
///
/// The smallest ellipsoid of this shape that holds all samples. It holds their convex hull too, so a point outside it
/// lies outside the hull; a point in between may lie outside the hull unnoticed. Cheap enough for every detection.
/// Source: "independent variable hull", Cook 1979, J. Am. Stat. Assoc. 74, p. 169.
struct Domain {
  std::vector<Interval> ranges;   ///< one for each parameter
  double largest_leverage = 0.0;  ///< of any sample
  std::vector<double> root;       ///< of h1 over u, as in Regression; empty for one parameter, or samples in a plane
};

/// Predicts one kind of error of a simulation over its parameters, with bounds:
///
///   confidence   f(x) -+ t s sqrt(h)           t  two-sided quantile of Student's distribution, n - k degrees
///   observation  f(x) -+ t s sqrt(1 + h)       s  residual_sd;  h  leverage (regression.h)
///
/// The bounds hold for one x at a time, not for the whole curve at once (functional, non-simultaneous). Without degrees
/// of freedom they are infinite. An error that is never negative (d_CAVM, d+, d-, d_AVM) is cut at 0 with its bounds.
/// A plain value, ready for a running simulation to ask at every detection: at() allocates nothing.
/// Source: Rosenberger 2023, doi:10.26083/tuprints-00023034, ch. 9 and 10; Seber & Lee 2003,
/// doi:10.1002/9780471722199, ch. 5.
struct Prediction {
  std::string target;  ///< "d_bias"
  bool never_negative = false;
  double level = 0.95;
  double quantile = std::numeric_limits<double>::infinity();  ///< t of this level; infinite if dof is 0
  double mean_error = 0.0;                                    ///< of the samples, weighted: the simplest prediction
  Regression regression;
  Domain domain;

  /// Throws InputError if the number of parameters is another or one is not finite.
  [[nodiscard]] PredictedError at(std::span<const double> x) const;
};

struct PredictionOptions {
  Family family = Family::Linear;
  double level = 0.95;
  bool never_negative = false;
};

/// Throws InputError as regress() does, or if the level is not between 0 and 1.
[[nodiscard]] Prediction predict(const ErrorSamples& samples, const PredictionOptions& options = {});

/// The same with bounds of another level.
[[nodiscard]] Prediction atLevel(Prediction prediction, double level);

}  // namespace metrics
