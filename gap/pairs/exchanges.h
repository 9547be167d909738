#pragma once

#include <vector>

#include "gap/candidates/candidates.h"
#include "gap/far/how_far.h"

namespace gap {

/// A pair with one of its members exchanged for a cause that, as it was fitted alone or in the member's own sector,
/// comes near beside the other, that is among the best alone, or of which the residuals beside the other count the
/// rate: fitted as well as the best pair is, unless it stays far behind, and put among the others by merit. Whether two
/// causes can be told apart beside a third one shows only where both were fitted beside it.
void exchangeMembersOf(const Candidate& pair, const Judge& quick, const Judge& exact, const HeldOutGaps& gaps,
                       const std::vector<Candidate>& singles, std::vector<Candidate>& pairs,
                       const core::Progress& progress);

}  // namespace gap
