#pragma once

#include <vector>

#include "gap/candidates/candidates.h"

namespace gap {

/// Whether two causes may be at work together as a pair: of different names, and neither an offset of single set-ups.
/// What is added has four numbers at most: a form of more takes long to fit beside others, and its usual form stands
/// for it.
[[nodiscard]] bool pairable(const Hypothesis& known, const Hypothesis& added);

/// Whether a cause, best ones first, is worth a look beside others: of those that hold on some of several sensors only
/// the sixteen that are best alone, for all of them would take long.
[[nodiscard]] bool worthPairing(const std::vector<Candidate>& singles, std::size_t single);

/// Both at once, with the values that each has; not judged yet.
[[nodiscard]] Candidate pairOf(const Candidate& a, const Candidate& b);

/// A cause beside another one, as it was fitted alone.
struct Partner {
  std::size_t single = 0;  ///< index of the cause
  double left = 0.0;       ///< discrepancy of both together, by all that is fitted
};

/// Every cause that may be a pair with `kept`, nearest to the measurement first. Looks at all that the judge has to fit
/// with: few shots do not show a loss or a false echo that is rare.
[[nodiscard]] std::vector<Partner> partnersOf(const Judge& judge, const Candidate& kept,
                                              const std::vector<Candidate>& singles, const core::Progress& progress);

}  // namespace gap
