#pragma once

#include <vector>

#include "gap/causes/hypotheses.h"
#include "gap/where/where.h"

namespace gap {

/// Values to begin a fit with that the residuals suggest, where an even search of the plausible range would miss the
/// cause: sectors and directions in azimuth from the strata where the gap lies and from `where.sectors`, gates and
/// false targets from strata of range, rates of false echoes from their number, dead times from the distances at which
/// second echoes are lost. Empty for a hypothesis that needs none.
[[nodiscard]] std::vector<std::vector<double>> startsFrom(const Replay& replay, const Hypothesis& hypothesis,
                                                          const WhereResult& where);

}  // namespace gap
