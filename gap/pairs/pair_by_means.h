#pragma once

#include <optional>
#include <span>
#include <vector>

#include "gap/candidates/candidates.h"

namespace gap {

/// The pair that brings the means of all that is fitted nearest (tried.h), if it takes nine tenths of what the nearest
/// of the leaders (the best single causes, and the pair that would be named) leaves of their squared deviations beyond
/// noise. That must be a part that matters of what was there at first; or be more than the noise, and with the pair
/// there is hardly more than noise: then no two programs differ. Deviations count however far they are here. What two
/// programs make of the echoes of a fog may be most of the robust discrepancy, and hides that a second cause takes all
/// of the rest; a cause that only stands in for that difference takes a part of it.
[[nodiscard]] std::optional<Candidate> pairByMeans(const Judge& quick, std::span<const Candidate> leaders,
                                                   const std::vector<Candidate>& pairs, const core::Progress& progress);

}  // namespace gap
