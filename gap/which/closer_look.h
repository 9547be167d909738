#pragma once

#include "gap/which/candidates.h"

namespace gap {

/// Where no cause explains half of a gap that is beyond doubt, it may lie in beams that are not among the few with
/// which causes are chosen (echoes that merge on one side of one car). So all are searched once more on the beams that
/// deviate most, and as many others, and those that come nearest there and nearer by all beams than before take their
/// places. `singles` stay best first. Does nothing where every beam took part before.
void lookCloser(const Judge& quick, const Judge& exact, const HeldOutGaps& gaps, const WhereResult& where,
                std::vector<Candidate>& singles, core::Progress& progress);

}  // namespace gap
