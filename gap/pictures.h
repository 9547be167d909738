#pragma once

#include <vector>

#include "gap/diagnosis.h"
#include "gap/replay.h"

namespace gap {

/// Maps of every measurand that deviates: of up to three samples in which it deviates most, both components of each
/// (bias and scatter, or missing and extra).
[[nodiscard]] std::vector<ResidualMap> residualMaps(const Replay& replay, const std::vector<ResidualTable>& tables);

/// Values for curves of the measurand that deviates most, of up to three held-out samples.
[[nodiscard]] std::vector<BeforeAfterValues> beforeAfterValues(const Replay& replay,
                                                               const std::vector<ResidualTable>& tables,
                                                               const std::vector<std::size_t>& held_out,
                                                               const World* after, std::uint64_t seed);

}  // namespace gap
