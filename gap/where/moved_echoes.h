#pragma once

#include <vector>

#include "gap/where/residual_tables.h"

namespace gap {

/// The same residuals beam by beam: where a beam lacks echoes of one surface and has as many from elsewhere, nothing is
/// missing and nothing extra; its echoes moved. Such a share of its shots becomes a residual of every channel,
///
///   mean of the echoes that came − mean of those that went,
///
/// and leaves the tables of existence (a car 0.2 m beside its recorded place moves the range of the beams at its edges
/// by the distance to the wall behind it). Only echoes beyond noise on both sides count as moved.
[[nodiscard]] std::vector<ResidualTable> withMovedEchoes(const Replay& replay, std::vector<ResidualTable> tables,
                                                         const CellsOfSamples& measured,
                                                         const CellsOfSamples& simulated);

}  // namespace gap
