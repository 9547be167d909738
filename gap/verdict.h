#pragma once

#include "gap/candidates/candidates.h"
#include "gap/diagnosis.h"
#include "gap/which/evidence_limits.h"

namespace gap {

// What the diagnosis says, and how far it is to be believed.

/// The causes that are listed, the verdict's first, with what they are believed with; the winner's own shrink is not
/// filled. `frames_deviate`: something else is at work, too.
void fillCauses(const Judge& judge, const HeldOutGaps& gaps, const Decision& decision, bool frames_deviate,
                Diagnosis& diagnosis, const core::Progress& progress);

/// Whether the named cause makes the echoes that lie where the scene has no surface: one that takes nearly all of the
/// deviation of all cells takes theirs, too.
[[nodiscard]] Stray strayIn(const Decision& decision);

/// Kind, names, evidence and limits, once the causes are filled. The confidence is that in the verdict as it stands:
/// that it is one of two, if it says that it cannot tell them apart; of a pair, that in the less certain of its
/// members. It is the lower the fewer the data are, and the worse a proxy stands for the model.
void fillVerdict(const Judge& judge, const Decision& decision, Diagnosis& diagnosis);

}  // namespace gap
