#pragma once

#include <vector>

#include "gap/candidates/candidates.h"

namespace gap {

/// Which two causes together look most like the measurement. First guesses are what a second search finds beside the
/// best single cause (second_search.h), the nearest partners of the one that brings the fitted samples nearest, and,
/// from signatures (signatures.h) of every candidate at values all over its plausible range, the nearest sums of two
/// and effects that another value of a parameter hides. All are led to where their signatures fit best
/// (signature_fit.h). They are fitted jointly and judged on held-out data like single candidates; then each member of
/// the best pair is exchanged for whatever goes better with the other one, as long as that helps. Best merit first. Two
/// forms of one cause are no pair, and offsets per set-up take no part.
[[nodiscard]] std::vector<Candidate> rankPairs(const Judge& judge, const std::vector<Candidate>& singles,
                                               core::Progress& progress);

}  // namespace gap
