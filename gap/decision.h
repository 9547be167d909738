#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gap/candidates.h"
#include "gap/diagnosis.h"
#include "gap/how_far.h"

namespace gap {

/// What the search for causes ended with.
struct Decision {
  VerdictKind kind = VerdictKind::kUnknown;
  std::optional<Candidate> winner;  ///< a single cause or a pair (Hypothesis::members)
  std::vector<Candidate> singles;   ///< best first
  std::vector<Candidate> pairs;     ///< those that were tried, best first
  std::vector<std::string> ties;    ///< causes that the data cannot tell from a single winner
  double noise = 0.0;               ///< standard deviation of an explained share
  double p_value = 1.0;             ///< of the best single cause's gain on held-out data, corrected for their number

  [[nodiscard]] bool pair() const { return winner && !winner->hypothesis.members.empty(); }
  /// Makes a candidate the winner.
  void name(const Candidate& candidate);
  /// Which causes the verdict names: a parameter or a reference beside an effect is a recalibration and not named.
  [[nodiscard]] std::vector<std::string> names() const;
};

/// Fits and judges every hypothesis alone; in pairs as long as something material is left that the best one does not
/// explain. `quick` sees some of the beams only and makes the choice of candidates; `exact` decides between them.
/// `clear`: a gap shows before any cause is tried; otherwise a cause must prove by its own gain that there is one.
/// docs/diagnosis.md gives the reasons for the bounds.
[[nodiscard]] Decision decide(const Judge& quick, const Judge& exact, const HeldOutGaps& gaps, bool clear,
                              const std::vector<WhereRow>& where, const std::vector<Hypothesis>& hypotheses,
                              core::Progress& progress);

/// Share of belief of each single candidate: a softmax of merits, times what the best one explains; the rest belongs to
/// what none of them says. `weak`: no whole sample was held out.
[[nodiscard]] std::vector<double> confidencesOf(const Decision& decision, bool weak);

}  // namespace gap
