#pragma once

#include <optional>

#include "gap/diagnosis.h"
#include "gap/which/decision.h"

namespace gap {

/// The sample, fitted or held out, in which two causes differ most, to be measured again: the one that is named and the
/// one that comes nearest to it, or the best of the others. Of two that are named together, one and what comes nearest
/// in its place beside the other. None if no cause is named, or no other was tried.
[[nodiscard]] std::optional<NextExperiment> nextExperiment(const Judge& judge, const Decision& decision);

}  // namespace gap
