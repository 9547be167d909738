#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gap/candidates/candidates.h"
#include "gap/far/how_far.h"
#include "gap/where/where.h"
#include "gap/which/rivals.h"

namespace gap {

struct Rest;

enum class VerdictKind { kNone, kEffect, kParameter, kReference, kUnknown };
[[nodiscard]] std::string toString(VerdictKind kind);

/// What the data show that no cause that was tried does, so that none is named however much it explains.
enum class Contradiction {
  kNone,
  kFramesMove,        ///< all detections of a frame deviate together (frame_mode.h)
  kLossesUneven,      ///< some beams lose many echoes and others none (uneven_loss.h)
  kFollowsDirection,  ///< plain functions of the beams' azimuth say it with fewer numbers (direction_laws.h)
  kOneStratum         ///< a stratum deviates beyond doubt, though all cells together do not, and no cause proved itself
};

/// What the search for causes ended with.
struct Decision {
  VerdictKind kind = VerdictKind::kUnknown;
  std::optional<Candidate> winner;    ///< a single cause or a pair (Hypothesis::members)
  std::vector<Candidate> singles;     ///< best first
  std::vector<Candidate> pairs;       ///< those that were tried, best first
  std::vector<Rival> rivals;          ///< that come near to a single winner, or to one of a pair that is named
  std::vector<Rival> recalibrations;  ///< numbers that may be wrong in place of one of two effects that are named
  Contradiction contradiction = Contradiction::kNone;
  double p_value = 1.0;  ///< of the gain that proved a cause where no gap is clear, times their number

  /// Causes that the data cannot tell from a single winner, or from one of a pair.
  [[nodiscard]] std::vector<std::string> ties() const;
  [[nodiscard]] bool pair() const { return winner && !winner->hypothesis.members.empty(); }
  /// Makes a candidate the winner.
  void name(const Candidate& candidate);
  /// None is named; there is a gap, and what it comes from is unknown.
  void nameNothing(Contradiction why = Contradiction::kNone);
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

/// Whether the winner leaves so much of the gap that follows something (`rest`) that it is not the cause; half of that
/// is enough if it follows a plain law and no second cause that was tried takes it. Not so if next to nothing is left
/// by another measure, of the discrepancy or of the total gap, or if the values show the cause by themselves.
[[nodiscard]] bool staysBelowCeiling(const Decision& decision, const Rest& rest);

/// Of the pairs that were tried, that in which a rival stands in a member's place; null if none was. The winner is a
/// pair.
[[nodiscard]] const Candidate* pairWith(const Decision& decision, const Rival& rival);

/// The pairs in which another cause stands in a member's place, by its name (Decision::ties).
[[nodiscard]] std::vector<std::pair<std::string, Candidate>> tiedPairs(const Decision& decision);

}  // namespace gap
