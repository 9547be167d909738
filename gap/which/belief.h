#pragma once

#include <string>
#include <vector>

#include "gap/which/decision.h"

namespace gap {

/// Belief that causes of a kind which account for so much of the gap (Judge::accountedFor) are among themselves the
/// right one: less where the gap is small (in wrong parameters most of all), more in wrong references, which other
/// causes seldom pose as.
[[nodiscard]] double beliefIn(const Yardstick& yardstick, double accounted_for, CauseKind kind);

/// Share of the belief in a pair that one of its members has, or one that may stand in a member's place.
[[nodiscard]] double shareOf(const Decision& decision, const std::string& cause);

/// Belief in each single candidate. Those that come near to the best one share it, each by how likely its separation
/// would be by chance, exp(-z²/2); the best one counts 2.5 times as much as one that nothing tells from it.
[[nodiscard]] std::vector<double> confidencesOf(const Decision& decision, double belief);

}  // namespace gap
