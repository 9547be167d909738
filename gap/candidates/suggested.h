#pragma once

#include <vector>

#include "core/progress.h"
#include "gap/candidates/candidates.h"
#include "gap/where/where.h"

namespace gap {

/// Of the starts that the residual map suggests the nearest one, if it is nearer than that; else empty.
[[nodiscard]] std::vector<double> nearestStart(const Replay& replay, const Hypothesis& hypothesis, const Evidence& few,
                                               double least, const WhereResult& where, const core::Progress& progress);

/// Rare echoes show in all beams only, and a few drawn ones more or less lead a search astray: where the map, which saw
/// all beams, suggests one place (the rate that was counted) and that leaves less of all that is fitted, it is taken.
[[nodiscard]] std::vector<double> orAsCounted(const Judge& exact, const Hypothesis& hypothesis,
                                              std::vector<double> values, const WhereResult& where);
/// The values that all beams suggest, where few beams led astray (the rate of rare echoes is counted); best merit
/// first.
void takeWhatIsCounted(const Judge& exact, const WhereResult& where, std::vector<Candidate>& candidates,
                       const core::Progress& progress);

}  // namespace gap
