#pragma once

#include <vector>

#include "gap/which/decision.h"

namespace gap {

/// Looks for two causes, and names them if both earn their place; the single causes learn from the joint fits. False if
/// none are named. docs/diagnosis.md ("Two causes") gives the order of the steps and the reasons for the bounds.
[[nodiscard]] bool namesAPair(const Judge& usual, const Judge& exact, const HeldOutGaps& gaps, const WhereResult& where,
                              Decision& decision, core::Progress& progress);

/// Names the first of some pairs; others of them may stand in a member's place.
void nameFirstOf(std::vector<Candidate>& pairs, const Judge& quick, const Judge& exact, Decision& decision);

}  // namespace gap
