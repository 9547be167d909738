#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "metrics/prediction/family.h"

namespace metrics {

/// Coefficients of an exponential or sigmoid of least squares, sum_i w_i (y_i - f(u_i))^2.
///
/// `points` holds row after row of parameters in [-1, 1]; the starts rely on that. Levenberg-Marquardt (Eigen's port of
/// MINPACK) from the best of a fixed set of starts: for a given exponent offset and factor have a closed solution, so
/// only exponents are searched. No randomness; the least sum wins, the earlier start among equals.
/// Throws InputError if no start converges or the data bend too little, or too abruptly, to tell the exponent.
/// Sources: Moré 1978, doi:10.1007/BFb0067700; separable starts: Golub & Pereyra 1973, doi:10.1137/0710036.
[[nodiscard]] std::vector<double> fitCurve(Family family, std::size_t parameters, std::span<const double> points,
                                           std::span<const double> errors, std::span<const double> weights);

}  // namespace metrics
