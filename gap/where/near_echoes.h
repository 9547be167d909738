#pragma once

#include <optional>

#include "gap/where/residual_tables.h"

namespace gap {

/// The distance of two echoes of one beam within which one of them is lost: what the merging of near echoes or a dead
/// time of the receiver would do. From the residuals of existence, and what the world expects; nothing if more echoes
/// are there than are lost, however near. Surfaces stand at few distances from each other, and between two of these a
/// cause of this kind changes nothing: a search along its number steps over the right ones. [m]
[[nodiscard]] std::optional<double> lossOfNearEchoes_m(const Replay& replay, const ResidualTable& missing,
                                                       const CellsOfSamples& expected);

}  // namespace gap
