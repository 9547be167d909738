#pragma once

#include <vector>

#include "core/progress.h"
#include "gap/candidates/candidates.h"
#include "gap/far/how_far.h"
#include "gap/where/where.h"

namespace gap {

class HeldOutGaps;

/// Whether the measured values show the steps of a coarse counter by themselves (Hypothesis::seen_in_values). Such a
/// counter is there beside whatever else is missing, and cell means hardly feel it. `singles`: best first, here and
/// below.
[[nodiscard]] bool showACounter(const std::vector<Candidate>& singles);

/// The counter in pairs, best first: with the best cause, with those that may stand in its place, and with what a
/// search beside the counter finds. None if with it cells agree less than without, or the total gap is larger.
[[nodiscard]] std::vector<Candidate> besideTheCounter(const Judge& quick, const Judge& exact, const HeldOutGaps& gaps,
                                                      const WhereResult& where, const std::vector<Candidate>& singles,
                                                      core::Progress& progress);
/// Whether the other member of such a pair brings what its numbers cost, or, where the counter is the best of all
/// causes, proves itself (SecondProofs); otherwise the counter is all.
[[nodiscard]] bool earnsBesideTheCounter(const Judge& exact, const std::vector<Candidate>& singles,
                                         const Candidate& pair);
/// The counter comes first.
void leadByTheCounter(std::vector<Candidate>& singles);

}  // namespace gap
