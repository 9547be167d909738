#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gap/candidates.h"
#include "gap/diagnosis.h"
#include "gap/how_far.h"
#include "gap/rivals.h"

namespace gap {

/// Of the gap, explained: such a cause need not shrink the pooled gap. Pooled data hide what evens out, and of what a
/// gate leaves in one sample they make much.
inline constexpr double kNearlyAllCells = 0.95;

/// What the search for causes ended with.
struct Decision {
  VerdictKind kind = VerdictKind::kUnknown;
  std::optional<Candidate> winner;  ///< a single cause or a pair (Hypothesis::members)
  std::vector<Candidate> singles;   ///< best first
  std::vector<Candidate> pairs;     ///< those that were tried, best first
  std::vector<Rival> rivals;        ///< that come near to a single winner, or to one of a pair that is named
  bool frames_move = false;         ///< all detections of a frame deviate together, which speaks against every cause
  double p_value = 1.0;             ///< of the gain that proved a cause where no gap is clear, times their number

  /// Causes that the data cannot tell from a single winner, or from one of a pair.
  [[nodiscard]] std::vector<std::string> ties() const;
  [[nodiscard]] bool pair() const { return winner && !winner->hypothesis.members.empty(); }
  /// Makes a candidate the winner.
  void name(const Candidate& candidate);
  /// Which causes the verdict names: a parameter or a reference beside an effect is a recalibration and not named.
  [[nodiscard]] std::vector<std::string> names() const;
  /// The members of a pair that it does not name.
  [[nodiscard]] std::vector<std::string> beside() const;
};

/// Fits and judges every hypothesis alone; in pairs as long as something material is left that the best one does not
/// explain. `quick` sees some of the beams only and makes the choice of candidates; `exact` decides between them.
/// `clear`: a gap shows before any cause is tried; otherwise a cause must prove by its own gain that there is one.
/// docs/diagnosis.md gives the reasons for the bounds.
[[nodiscard]] Decision decide(const Judge& quick, const Judge& exact, const HeldOutGaps& gaps, bool clear,
                              const WhereResult& where, const std::vector<Hypothesis>& hypotheses,
                              core::Progress& progress);

/// Belief that causes which account for so much of the gap (Judge::accountedFor) are among themselves the right one:
/// less where the gap is small.
[[nodiscard]] double beliefIn(const Yardstick& yardstick, double accounted_for);

/// Share of the belief in a pair that one of its members has, or one that may stand in a member's place.
[[nodiscard]] double shareOf(const Decision& decision, const std::string& cause);
/// Those that may stand in a member's place (Decision::ties), as they were fitted beside the other one.
[[nodiscard]] std::vector<Candidate> tiedPartners(const Decision& decision);

/// Belief in each single candidate. Those that come near to the best one share it, each by how likely its separation
/// would be by chance, exp(-z²/2).
[[nodiscard]] std::vector<double> confidencesOf(const Decision& decision, double belief);

}  // namespace gap
