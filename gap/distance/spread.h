#pragma once

#include <vector>

#include "gap/distance/comparison.h"
#include "gap/replay/replay.h"

namespace gap {

/// Variance of one detection within cells, pooled. [squared unit of the channel]
struct PooledSpread {
  double degrees_of_freedom = 0.0;
  double variance = 0.0;
  double usual = 0.0;  ///< of the cell in the middle: those at edges scatter more

  [[nodiscard]] bool known() const { return degrees_of_freedom >= 5.0; }
};

/// Cells of like predicted power, and how much their detections scatter on both sides.
struct GroupSpread {
  std::vector<std::size_t> cells;
  PooledSpread measured;
  PooledSpread simulated;
};

/// Variance that the profile states for one detection: a prior where a cell has few of them.
[[nodiscard]] double priorVariance(const Replay& replay, const ReplaySample& sample, Channel channel);

/// Groups of `cells`, which are in order of power; those that one side alone detects take part in no spread. No cell
/// counts with more than ten times the variance that is usual in its group or stated by the profile (`prior`): one
/// foreign pulse that is merged with an echo would outweigh all the others.
[[nodiscard]] std::vector<GroupSpread> spreadsOf(const std::vector<std::size_t>& cells, const Comparison& comparison,
                                                 Channel channel, double prior);

/// How far the spreads of both sides are apart, as a part of `discrepancy`.
[[nodiscard]] double spreadDiscrepancy(const std::vector<GroupSpread>& groups, double prior);

/// Variance of one detection of a cell on both sides together, and of `prior` as if there were six more of them.
[[nodiscard]] double pooledVariance(const CellStatistics& a, const CellStatistics& b, Channel channel, double prior);

/// Variance of one detection of a cell: of its own detections, and of its group's as if there were six more of them;
/// nothing of the cell where its group tells nothing: then `prior` stands for the group.
[[nodiscard]] double varianceIn(const PooledSpread& group, const CellStatistics& cell, Channel channel, double prior);

}  // namespace gap
