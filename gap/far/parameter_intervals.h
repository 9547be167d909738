#pragma once

#include <vector>

#include "core/progress.h"
#include "gap/causes/fit.h"
#include "gap/far/how_far.h"

namespace gap {

/// Jackknife over set-ups: refits the winner without each of them, or of many without each of some groups (Kott 2001,
/// J. Off. Stat. 17, 521). Within the plausible range of every number. [parameter order of the hypothesis] Empty with
/// fewer than two set-ups, and for offsets that belong to one set-up each.
[[nodiscard]] std::vector<Interval> parameterIntervals(const Replay& replay, const Hypothesis& hypothesis,
                                                       const std::vector<double>& values, const Evidence& evidence,
                                                       const core::Progress& progress);

}  // namespace gap
