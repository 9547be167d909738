#pragma once

#include <vector>

#include "gap/candidates/candidates.h"

namespace gap {

/// Some causes of one number each are one world under two names: a threshold that is kept at a multiple of the noise,
/// and another threshold. Each is fitted by its own search, which ends somewhere in a flat valley, and where they end
/// apart the data seem to tell them apart. So every cause of one number is asked at which value it makes the world of
/// a leading one; where there is such a value and it is better than that of its own fit, it is taken. Best merit first.
/// `quick` sees some of the beams and looks for the values, `exact` judges them.
void takeValuesOfTwins(const Judge& quick, const Judge& exact, std::vector<Candidate>& singles,
                       const core::Progress& progress);

}  // namespace gap
