#pragma once

#include "gap/causes/evidence.h"
#include "gap/where/where.h"

namespace gap {

/// Where causes are looked for first: a few samples, spread over all of the evidence, and the one that deviates most,
/// if none of the few deviates a third as much. What takes echoes from the darkest panel at the longest range alone
/// acts in no other sample. `where`: the residuals of the world beside which they are looked for.
[[nodiscard]] Evidence scoutedSamples(const Evidence& evidence, const WhereResult& where);

}  // namespace gap
