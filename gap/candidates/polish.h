#pragma once

#include <vector>

#include "core/progress.h"
#include "gap/candidates/candidates.h"
#include "gap/far/how_far.h"
#include "gap/where/where.h"

namespace gap {

/// Fits the leaders again with more frames and beams, from where they are and from what the residual map suggests, and
/// judges them again, by what they leave of the total gap as well; the leaders come first, by merit, and so do the
/// rest.
void polish(const Judge& judge, const HeldOutGaps& gaps, std::vector<Candidate>& candidates, const WhereResult& where,
            const core::Progress& progress);

}  // namespace gap
