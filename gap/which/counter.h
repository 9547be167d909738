#pragma once

#include <vector>

#include "core/progress.h"
#include "gap/which/candidates.h"

namespace gap {

class HeldOutGaps;

/// Whether the measured values show the steps of a coarse counter by themselves (Hypothesis::seen_in_values). Such a
/// counter is there beside whatever else is missing, and cell means hardly feel it. `singles`: best first, here and
/// below.
[[nodiscard]] bool showACounter(const std::vector<Candidate>& singles);

/// The counter in pairs with the best causes, best first: with the best one, and with those that may stand in that
/// one's place. None if the best cause is the counter, or if with it cells agree less than without, or the total gap is
/// larger.
[[nodiscard]] std::vector<Candidate> besideTheCounter(const Judge& quick, const Judge& exact, const HeldOutGaps& gaps,
                                                      const WhereResult& where, const std::vector<Candidate>& singles,
                                                      const core::Progress& progress);
/// Whether the other member of such a pair brings what its numbers cost; otherwise the counter is all.
[[nodiscard]] bool earnsBesideTheCounter(const Judge& exact, const Candidate& pair);
/// The counter comes first.
void leadByTheCounter(std::vector<Candidate>& singles);

}  // namespace gap
