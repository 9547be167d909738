#pragma once

#include <cstddef>
#include <vector>

#include "gap/replay.h"

namespace gap {

/// Which cells of a sample take part: all, or those of every second beam column (to hold the rest out).
enum class Half { kAll, kEven, kOdd };

/// How far a simulation is from the measurement, as a sum over cells of robust standardised differences
///
///   ρ(z) = sqrt(1 + z²) - 1
///
/// of the mean of every channel and of the detections per frame, and (over groups of cells of like predicted power) of
/// the detections per frame and the spread. Quadratic near zero, linear far out, so that a few badly sampled edge beams
/// decide nothing. z is the difference over its standard error, which holds a floor: differences below a fraction of a
/// resolution step are not worth explaining. Of one sample, between its measurement (or `measured` in its place) and
/// simulated statistics.
[[nodiscard]] double discrepancy(const Replay& replay, std::size_t sample, const std::vector<CellStatistics>& measured,
                                 int measured_frames, const std::vector<CellStatistics>& simulated,
                                 int simulated_frames, Half half = Half::kAll);

/// Standard error of the difference of two cell means, floor included. [unit of the channel]
[[nodiscard]] double meanError(const Replay& replay, Channel channel, const CellStatistics& a, const CellStatistics& b);

}  // namespace gap
