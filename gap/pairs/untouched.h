#pragma once

#include <vector>

#include "gap/candidates/candidates.h"

namespace gap {

/// In which aspects of the held-out data a cause does nothing, next to how far the model is from the measurement there:
/// coarse steps of the range leave every intensity as it is. What is missing there is not its doing, and no program
/// makes the cause differently there.
[[nodiscard]] Aspects untouchedBy(const Judge& judge, const Candidate& cause);

/// The held-out data as far as a known cause leaves them untouched, in which a second cause is judged as if there were
/// nothing else. What is called the whole gap there is what the known cause leaves of it.
class WhereUntouched {
 public:
  WhereUntouched(const Judge& exact, Candidate known);

  /// Whether a gap beyond doubt is left there.
  [[nodiscard]] bool missesSomething() const;
  /// Second causes beside the known one, found there: those that account there for enough to be named, best first, with
  /// what all data say of them; but for their `total_left`. `quick` sees some of the beams only and makes the choice.
  [[nodiscard]] std::vector<Candidate> pairs(const Judge& quick, const std::vector<Candidate>& singles,
                                             core::Progress& progress) const;
  /// Whether a pair leaves no more there than it would if it were right.
  [[nodiscard]] bool nothingLeftBy(const Candidate& pair) const;

 private:
  const Judge& exact_;
  Candidate known_;
  Judge there_;
};

}  // namespace gap
