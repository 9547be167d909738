#pragma once

#include <cstddef>
#include <optional>

#include "metrics/series/series_pair.h"

namespace metrics {

/// Lags up to which correlations are computed if nothing is said: a quarter of the series, but at least one value.
/// Beyond, too few pairs overlap. Source: Box, Jenkins & Reinsel 2008, doi:10.1002/9781118619193, ch. 2.
[[nodiscard]] std::size_t usualLargestLag(std::size_t n);

struct CrossCorrelation {
  double maximum;  ///< in [-1, 1]
  double lag;      ///< where it is [values]; > 0: the simulation comes later than the measurement
};

/// Largest normalised cross-correlation of two evenly sampled series, and where it is.
///
///   r(k) = sum_i (x_i - mean x) (y_{i+k} - mean y) / sqrt( sum (x - mean x)^2  sum (y - mean y)^2 )
///
/// x measured, y simulated, |k| <= largest lag; r(0) is Pearson's r. Means and norms are those of the whole series, so
/// that lags with little overlap weigh little (not divided by the number of overlapping pairs). The largest r is
/// meant, not |r|; among equals, the lag nearest to 0, then the positive one. Costs n operations a lag.
///
/// Both are NaN if a series is constant (whyUncorrelated). Throws InputError if the sides do not pair or the largest
/// lag is not below n.
[[nodiscard]] CrossCorrelation crossCorrelation(const SeriesPair& pair, std::optional<std::size_t> largest_lag = {});

/// Mean over the lags k = 1 … K of |a_simulated(k) - a_measured(k)|, in [0, 2]; a(k) is the r(k) of a series with
/// itself. It compares the memory of two signals (periods, drift, noise colour) without regard to when something
/// happens: a series played backwards has distance 0. That differences are averaged in magnitude is our choice.
///
/// NaN if a series is constant (whyUncorrelated). Throws InputError if the sides do not pair or K is not below n or
/// is 0.
[[nodiscard]] double autocorrelationDifference(const SeriesPair& pair, std::optional<std::size_t> largest_lag = {});

}  // namespace metrics
