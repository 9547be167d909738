#pragma once

#include "gap/candidates/candidates.h"
#include "gap/candidates/signatures.h"

namespace gap {

/// Where two numbers of a cause make up for each other (at what power a receiver saturates, and how softly it bends),
/// the data lie in a valley a thousandth of a range wide. Beside it every cell is wrong by more than counts, so that no
/// search by distances finds the way along it; the shifts of the cells do. Looks from a few places of each number, at
/// some of the beams.
class Valleys {
 public:
  explicit Valleys(const Judge& judge);
  Valleys(const Valleys&) = delete;
  Valleys& operator=(const Valleys&) = delete;

  /// Whether it has several numbers that shift the data by degrees.
  [[nodiscard]] static bool mayHelp(const Candidate& candidate);

  /// Values that came nearest that way, by some of the beams; the candidate's own where it has but one number, or moves
  /// rays.
  [[nodiscard]] std::vector<double> lowestFrom(const Candidate& candidate, const core::Progress& progress) const;

 private:
  Replay few_;
  Evidence evidence_;
  SignatureSpace space_;
};

}  // namespace gap
