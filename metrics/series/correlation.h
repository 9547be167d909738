#pragma once

#include <optional>
#include <string_view>

#include "metrics/series/series_pair.h"

namespace metrics {

/// Why the pair has no correlation, e.g. "the measured series is constant": the quotient is then 0/0, and every
/// correlation of the pair NaN. A single value is constant. Nothing if there is a correlation.
[[nodiscard]] std::optional<std::string_view> whyUncorrelated(const SeriesPair& pair);

/// Pearson's correlation coefficient r of the paired values, in [-1, 1].
///
///   r = sum (x - mean x) (y - mean y) / sqrt( sum (x - mean x)^2  sum (y - mean y)^2 )
///
/// Blind to offset and gain: a simulation that is 5 m too far throughout has r = 1. NaN: see whyUncorrelated. Throws
/// InputError if the sides do not pair. Source: Pearson 1895, doi:10.1098/rspl.1895.0041.
[[nodiscard]] double pearsonCorrelation(const SeriesPair& pair);

/// Coefficient of determination of the simulation as a prediction of the measurement, in (-inf, 1].
///
///   R^2 = 1 - sum (simulated - measured)^2 / sum (measured - mean measured)^2
///
/// 0: no better than the mean of the measurement; negative: worse. Not the square of r, because nothing is fitted.
/// NaN if the measured series is constant. Throws InputError if the sides do not pair.
/// Source: Nash & Sutcliffe 1970, doi:10.1016/0022-1694(70)90255-6, eq. 3.
[[nodiscard]] double coefficientOfDetermination(const SeriesPair& pair);

}  // namespace metrics
