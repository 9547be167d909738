#pragma once

#include <vector>

#include "gap/candidates/candidates.h"

namespace gap {

/// A cause found beside another one.
struct Found {
  std::size_t single = 0;      ///< index of the cause
  std::vector<double> values;  ///< its own
};

/// The search for a single cause made once more where one is known, as closely: its residuals say where to begin, and
/// all samples that are fitted say how near each cause comes beside it. Of each name the nearest form; nearest first,
/// free numbers paid for; four at most, and none that brings less than it costs.
[[nodiscard]] std::vector<Found> searchedBeside(const Judge& judge, const Candidate& known,
                                                const std::vector<Candidate>& singles, core::Progress& progress);

/// The known cause in pairs with those of them that bring more than they cost on held-out samples, too, as `exact`
/// judges these; best merit first.
[[nodiscard]] std::vector<Candidate> pairsBeside(const Judge& quick, const Judge& exact, const Candidate& known,
                                                 const std::vector<Candidate>& singles, core::Progress& progress);

}  // namespace gap
