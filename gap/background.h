#pragma once

#include "gap/candidates/candidates.h"
#include "gap/diagnosis.h"
#include "gap/which/decision.h"

namespace gap {

/// What a reader must know of the data and of the search.
[[nodiscard]] Background backgroundOf(const Replay& replay, const Split& split, const Decision& decision);

/// The worlds of the causes that a diagnosis lists, in their order; of a pair each member alone.
[[nodiscard]] std::vector<NamedWorld> worldsOf(const Replay& replay, const Decision& decision,
                                               const std::vector<Cause>& causes);

}  // namespace gap
