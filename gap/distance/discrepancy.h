#pragma once

#include <span>

#include "gap/distance/comparison.h"
#include "gap/replay/replay.h"

namespace gap {

/// ρ of `discrepancy`.
[[nodiscard]] double robustLoss(double z);

/// ρ of a term that stands for many cells and is weighted by them: nothing up to one standard error, for its noise
/// would be weighted as well.
[[nodiscard]] double groupLoss(double z);

/// How far a simulation is from the measurement, as a sum over cells of robust standardised differences
///
///   ρ(z) = sqrt(1 + z²) - 1
///
/// of the mean of every channel and of the detections per frame, and (over groups of cells of like predicted power) of
/// the detections per frame and the spread. Quadratic near zero, linear far out, so that a few badly sampled edge beams
/// decide nothing. z is the difference over its standard error, which holds a floor: differences below a fraction of a
/// resolution step are not worth explaining.
[[nodiscard]] double discrepancy(const Replay& replay, std::span<const Comparison> comparisons, Part part = {});

/// Standard error of the difference of two means of a cell: of its noise, of the resolution, and of what the
/// reference's tolerance does to the power that the cell receives. [unit of the channel]
[[nodiscard]] double meanError(const Replay& replay, const ReplaySample& sample, std::size_t cell, Channel channel,
                               const CellStatistics& measured, const CellStatistics& simulated);

/// The same with the noise that the sensor profile states as a prior where a cell has few detections.
[[nodiscard]] double comparableError(const Replay& replay, const ReplaySample& sample, std::size_t cell,
                                     Channel channel, const CellStatistics& measured, const CellStatistics& simulated);

/// Whether a cell belongs to this part.
[[nodiscard]] bool takesPart(const ReplaySample& sample, const Cell& cell, Part part);

}  // namespace gap
