#pragma once

#include "metrics/series/series_pair.h"

namespace metrics {

/// Distances of two series from the differences d_i = simulated_i - measured_i. All are 0 for equal series and do not
/// depend on the order of the pairs. Throw InputError if the sides do not pair (series_pair.h).
///
/// Sums grow with the number of pairs n: compare them only between series of equal length, or use the mean beside them.
///
///            of |d|                      of d^2
///   sum      manhattanDistance           residualSumOfSquares     euclideanDistance = root of it
///   mean     meanAbsoluteError           meanSquareError          rootMeanSquareError = root of it
///   largest  chebyshevDistance
///
/// Units: that of the measurand, squared where the name says square.
/// Sources: Deza & Deza 2016, doi:10.1007/978-3-662-52844-0; Willmott & Matsuura 2005, doi:10.3354/cr030079.

[[nodiscard]] double manhattanDistance(const SeriesPair& pair);     // sum |d|; also known as overall error
[[nodiscard]] double euclideanDistance(const SeriesPair& pair);     // sqrt(sum d^2)
[[nodiscard]] double chebyshevDistance(const SeriesPair& pair);     // max |d|
[[nodiscard]] double residualSumOfSquares(const SeriesPair& pair);  // sum d^2
[[nodiscard]] double meanSquareError(const SeriesPair& pair);       // sum d^2 / n
[[nodiscard]] double rootMeanSquareError(const SeriesPair& pair);   // sqrt(sum d^2 / n)

/// sum |d| / n, the "mean error" by its formula. Tables of the dissertation print |difference of the means| under that
/// name: a smaller number, in which errors of both signs cancel (metrics/samples/moment_differences.h).
[[nodiscard]] double meanAbsoluteError(const SeriesPair& pair);

/// sum d / n; > 0: simulated values are too high. 0 does not mean equal.
[[nodiscard]] double meanSignedError(const SeriesPair& pair);

}  // namespace metrics
