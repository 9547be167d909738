#pragma once

#include <vector>

#include "core/progress.h"
#include "gap/candidates/candidates.h"
#include "gap/far/how_far.h"

namespace gap {

/// Of the gap, explained: such a cause need not shrink the pooled gap. Pooled data hide what evens out, and of what a
/// gate leaves in one sample they make much.
inline constexpr double kNearlyAllCells = 0.95;

/// Of the total gap, noise and all: two causes that leave more are not the causes.
inline constexpr double kMostRestOfPair = 0.5;

/// Says of a candidate, with the values that it has, what the held-out data say of it: of the total gap first, which
/// counts in its merit, then cell by cell (Judge::hear).
void hearOnTotal(const Judge& judge, const HeldOutGaps& gaps, Candidate& candidate);

/// What a candidate leaves of the total gap, as a share of all of it: of a gap that is mostly noise a right cause takes
/// little, and `total_left` is guesswork.
[[nodiscard]] double restOfWholeGap(const HeldOutGaps& gaps, const Candidate& candidate);

/// Whether a cause stays named that makes the total gap smaller by such a share. Where it is none the smaller, the
/// cause only fitted single cells, unless it explains nearly all of them: pooled data hide what evens out (a car
/// reported late, that leaves here as many echoes as it makes there); or unless what is left is its own noise (two sets
/// of a few false alarms are as far from each other as one is from none).
[[nodiscard]] bool holdsOnTotal(const Candidate& winner, double shrink);

/// Where the best cause does not hold on the total gap, puts before it the first that does, beyond luck, and accounts
/// for `enough` of the gap: a larger noise scatters as a coarse counter does, but makes no steps.
void leadOnTotal(const Judge& exact, const HeldOutGaps& gaps, double enough, std::vector<Candidate>& singles,
                 const core::Progress& progress);

}  // namespace gap
