#pragma once

#include <cstddef>
#include <span>

#include "metrics/sensitivity/sensitivity_indices.h"

namespace metrics {

/// Extended FAST: first-order and total indices of one output, given row by row of fastPlan(k parameters, n, curves).
/// Along block i, parameter i swings with the high frequency w, all others with low ones. In the spectrum of the output
///
///   S_i  = power at w, 2 w, … 4 w / whole power        S_Ti = 1 - power up to w / 2 / whole power
///
/// Values are means of the curves; with two or more, intervals are mean -+ t s / sqrt(curves). They hold the scatter
/// between random phases; the bias of a short curve (total of an inert parameter some 0.01 too high) they do not hold.
/// Throws InputError unless there are n k curves finite outputs, and as fastPlan does for n.
/// Source: Saltelli, Tarantola & Chan 1999, doi:10.1080/00401706.1999.10485594.
[[nodiscard]] SensitivityResult fastIndices(std::span<const double> outputs, std::size_t parameters, std::size_t n,
                                            std::size_t curves, double confidence = 0.95);

}  // namespace metrics
