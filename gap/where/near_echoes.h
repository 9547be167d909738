#pragma once

#include <optional>

#include "gap/where/residual_tables.h"

namespace gap {

/// The distance of two echoes of one beam within which one of them is lost: by the ranges that are reported, as a dead
/// time of the receiver would take them; and by their peaks, as they would merge. (Of a sensor that reports leading
/// edges a strong echo is nearer than its peak.)
struct NearEchoes {
  std::optional<double> within_m;
  std::optional<double> peaks_within_m;
};

/// From the residuals of existence, and what the world expects; nothing if more echoes are there than are lost, however
/// near. Surfaces stand at few distances from each other, and between two of these a cause of this kind changes
/// nothing: a search along its number steps over the right ones.
[[nodiscard]] NearEchoes lossOfNearEchoes(const Replay& replay, const ResidualTable& missing,
                                          const CellsOfSamples& expected);

}  // namespace gap
