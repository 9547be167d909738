#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gap/candidates/candidates.h"

namespace gap {

/// A cause that comes near to the best one.
struct Rival {
  std::string name;
  double separation = 0.0;   ///< how much farther from all samples, in standard deviations of that difference, and
                             ///< what its further free numbers cost; 0: as near
  std::string instead_of{};  ///< of a pair: the member in whose place it stands beside the other one

  /// Whether the data cannot tell it from the best one.
  [[nodiscard]] bool tied() const noexcept;
};

/// How well the first candidate is told from those that come near to it in merit. docs/diagnosis.md gives the reasons
/// for the bounds. `quick` sees some of the beams, enough for the samples that were fitted (separationOnAll).
[[nodiscard]] std::vector<Rival> rivalsOf(const Judge& quick, const Judge& exact,
                                          const std::vector<Candidate>& candidates);
/// The same from all, however far behind: merits are shares of the gap, which say little where there is hardly any.
[[nodiscard]] std::vector<Rival> rivalsOfAll(const Judge& quick, const Judge& exact,
                                             const std::vector<Candidate>& candidates);

/// The cause that one pair has in place of an effect of another pair, which are otherwise the same; its separation is
/// left open. None where that is a parameter: it would not be named (leadByPlainest, recalibrationsInPairs).
[[nodiscard]] std::optional<Rival> exchangedIn(const Candidate& other, const Candidate& best);

/// Of what the nearest of the leading pairs explains, the share that the best single cause does not. What a pair
/// explains is mostly its better member's: two pairs are alike if they are so by the measure of what the second adds.
[[nodiscard]] double addedBySecond(const Candidate& single, const std::vector<Candidate>& pairs);

/// Causes that may stand in the place of one of the best pair's; `added`: addedBySecond.
[[nodiscard]] std::vector<Rival> rivalsInPairs(const Judge& quick, const Judge& exact,
                                               const std::vector<Candidate>& pairs, double added);

/// Parameters whose other value does, beside one of two effects, what the other effect does: the data cannot tell
/// whether that effect is missing or that number is wrong. None if the best pair is not of two effects.
[[nodiscard]] std::vector<Rival> recalibrationsInPairs(const Judge& quick, const Judge& exact,
                                                       const std::vector<Candidate>& pairs, double added);

/// Held-out samples are few. Of causes that come near to the best one, each takes its place that is nearer by all
/// samples, by more than what it takes more to say it. `added`, of pairs: addedBySecond.
void leadByAll(const Judge& quick, const Judge& exact, std::vector<Candidate>& candidates, double added = 1.0);

/// Of causes, or pairs, that the data cannot tell from the best one, the plainest first: two effects before one with a
/// recalibration, which would not be named, so that the effect in its place would be missed; and what accounts for
/// as much with fewer numbers, or in its usual form (speckle before a jitter of the power alone). `added`, of pairs:
/// addedBySecond.
void leadByPlainest(const Judge& quick, const Judge& exact, std::vector<Candidate>& candidates, double added = 1.0);

}  // namespace gap
