#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gap/candidates.h"
#include "gap/diagnosis.h"

namespace gap {

/// What the search for causes ended with.
struct Decision {
  VerdictKind kind = VerdictKind::kUnknown;
  std::optional<Candidate> winner;  ///< a single cause or a pair (Hypothesis::members)
  std::vector<Candidate> singles;   ///< best first
  double left_of_total = 1.0;       ///< of the total gap, beyond what a right model keeps, with the winner added

  [[nodiscard]] bool pair() const { return winner && !winner->hypothesis.members.empty(); }
  /// Which causes the verdict names: a parameter or a reference beside an effect is a recalibration and not named.
  [[nodiscard]] std::vector<std::string> names() const;
};

/// Fits and judges every hypothesis alone; in pairs as long as something material is left that the best one does not
/// explain. `quick` sees some of the beams only and makes the choice of candidates; `exact` decides between them.
/// docs/diagnosis.md gives the reasons for the bounds.
[[nodiscard]] Decision decide(const Judge& quick, const Judge& exact, const std::vector<WhereRow>& where,
                              const std::vector<std::string>& library, core::Progress& progress);

/// Share of belief of each candidate: a softmax of merits, times what the best one explains; the rest belongs to what
/// none of them says. `weak`: no whole sample was held out.
[[nodiscard]] std::vector<double> confidencesOf(const std::vector<Candidate>& candidates, bool weak);

/// Causes that the data cannot tell from the best one.
[[nodiscard]] std::vector<std::string> tiesOf(const std::vector<Candidate>& candidates);

}  // namespace gap
