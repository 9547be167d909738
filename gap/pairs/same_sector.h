#pragma once

#include <vector>

#include "gap/candidates/candidates.h"
#include "gap/far/how_far.h"
#include "gap/where/where.h"

namespace gap {

/// Those of the others that act in a sector of azimuths too (dirt on the window, light that blinds, a false target),
/// put into the sector of the known cause, with the strengths that they have; not judged yet. What one cause shows of
/// a sector's edges is true of all: a fit that ends a step beside them makes a cause seem farther from the data than
/// it is. Empty if the known cause acts in no sector.
[[nodiscard]] std::vector<Candidate> inSectorOf(const Candidate& known, const std::vector<Candidate>& others);

/// Judges the causes that act in a sector in that of the first one as well, if it acts in one, by all beams and by the
/// total gap, and fits again and keeps what is better there; best merit first then, else as they were.
void shareTheSector(const Judge& exact, const HeldOutGaps& gaps, const WhereResult& where,
                    std::vector<Candidate>& singles, const core::Progress& progress);

}  // namespace gap
