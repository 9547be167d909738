#pragma once

#include <optional>
#include <utility>

#include "gap/candidates/candidates.h"
#include "gap/candidates/significance.h"
#include "gap/far/how_far.h"

namespace gap {

/// Whether a second cause could earn its place at all: no pair can gain more than what the best single cause leaves,
/// and that must be a gap beyond doubt, or a part of the whole one that matters and is more than noise, or shows where
/// all data are pooled. `left_by_best`, here and below: deviationsLeft the best single cause.
[[nodiscard]] bool roomForASecond(const Judge& judge, const Candidate& best, double left_by_best);

/// Whether an effect scatters so much more than a right model that its noise may hide what else is missing: what
/// speckle leaves is never a gap.
[[nodiscard]] bool mayHideASecond(const Judge& judge, const Candidate& best);

/// The member of a pair that is better alone, with the values that it has there, by all beams: what few beams show (two
/// echoes that merge in one column) may have been found beside another cause only.
[[nodiscard]] Candidate betterMember(const Judge& exact, const HeldOutGaps& gaps, const Candidate& pair);

/// Whether one of a pair does at least as well alone: it is no farther from the data, on held-out samples and on all.
[[nodiscard]] bool doesAsWellAlone(const Judge& quick, const Judge& exact, const Candidate& member,
                                   const Candidate& pair);

/// Whether a pair is nearer to the data than the best single cause by more than luck, and by so much, or so little
/// being left, that a second cause is there. `quick` sees some of the beams, enough for the samples that were fitted.
/// docs/diagnosis.md gives the reasons for the bounds.
[[nodiscard]] bool earnsItsSecond(const Judge& quick, const Judge& exact, const Candidate& best, double left_by_best,
                                  const Candidate& pair);
/// The same of a pair that takes what all other leaders leave of the means (pair_by_means.h): it need not take so much
/// of the discrepancy.
[[nodiscard]] bool earnsItsSecondByMeans(const Judge& quick, const Judge& exact, const Candidate& best,
                                         const Candidate& pair);
/// The same of a pair that accounts for what is missing where the best single cause does nothing (untouched.h). If it
/// leaves nothing there, it may leave more of the total gap than the single cause, but not all of it: pooled data count
/// edges, which programs differ in.
[[nodiscard]] bool earnsItsSecondElsewhere(const Judge& quick, const Judge& exact, const Candidate& best,
                                           const Candidate& pair, bool nothing_left_there);

/// Second causes beside a single one that prove themselves, one of so many causes: each gains what chance gives none of
/// them, as much of it as a cause that is there would bring, and leaves nothing. This sees what is in no rest: the
/// noise of the first cause (speckle, lost shots) hides it, and cancels where both worlds are simulated with the same
/// random numbers. What chance gives is drawn once, when it is first needed.
class SecondProofs {
 public:
  SecondProofs(const Judge& exact, Candidate single, std::size_t causes)
      : exact_(exact), single_(std::move(single)), causes_(causes) {}

  [[nodiscard]] bool of(const Candidate& pair);

 private:
  const Judge& exact_;
  Candidate single_;
  std::size_t causes_;
  std::optional<NullRuns> nulls_;
};

}  // namespace gap
