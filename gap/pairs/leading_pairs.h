#pragma once

#include <vector>

#include "gap/candidates/candidates.h"

namespace gap {

/// Whether two pairs are of the same causes, in the same forms, whichever comes first.
[[nodiscard]] bool samePair(const Candidate& a, const Candidate& b);

/// Puts a pair among others, unless they hold the same one with values that are as good; order is left to the caller.
void takePair(Candidate pair, std::vector<Candidate>& pairs);

/// Puts every two of the leading single causes among the pairs, with the values that each has alone, judged by all
/// beams; best merit first. Few beams choose the partners of a cause, and may not see one that a single beam shows,
/// though it was found alone (a false target of a tenth of a degree beside an offset of all ranges), nor that the
/// values which they led to are worse than those (a gate that nothing but a held-out wall shows). The merits of pairs
/// that are known may be of few beams.
void joinLeaders(const Judge& exact, const std::vector<Candidate>& singles, std::vector<Candidate>& pairs,
                 const core::Progress& progress);

}  // namespace gap
