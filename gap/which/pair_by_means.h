#pragma once

#include <optional>
#include <vector>

#include "gap/which/candidates.h"

namespace gap {

/// The pair that brings the means of all that is fitted nearest (bicOf, tried.h), if it takes nine tenths of what the
/// nearest of the best single causes leaves of their squared deviations, and that is a part that matters of what was
/// there at first. Deviations count however far they are here. What two programs make of the echoes of a fog may be
/// most of the robust discrepancy, and hides that a second cause takes all of the rest; a cause that only stands in for
/// that difference takes a part of it.
[[nodiscard]] std::optional<Candidate> pairByMeans(const Judge& quick, const std::vector<Candidate>& singles,
                                                   const std::vector<Candidate>& pairs, const core::Progress& progress);

}  // namespace gap
