#pragma once

#include <span>

#include "gap/distance/comparison.h"
#include "gap/replay/replay.h"

namespace gap {

/// Whether the surface of a cell should lose no shot: off all edges, and its echo has at least twice the power of the
/// threshold, which is four times the noise or more.
[[nodiscard]] bool losesNothing(const Cell& cell);

/// How far a simulation is from the measurement in echoes of surfaces that should lose nothing, over all samples of a
/// sensor together. A loss of one shot in a hundred is noise in every cell and every sample. Weighed with the root of
/// the number of cells, as the groups in discrepancy.h are, and like those nothing up to one standard error.
[[nodiscard]] double lostDiscrepancy(const Replay& replay, std::span<const Comparison> comparisons, Part part);

}  // namespace gap
