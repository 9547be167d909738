#pragma once

#include <vector>

#include "gap/where/residual_tables.h"

namespace gap {

/// Azimuths from one to another.
struct Sector {
  double from_deg = 0.0;
  double to_deg = 0.0;
};

/// The sectors that explain residuals best, best first: of each table the one that leaves least variance if the
/// residuals, in their errors, have one mean inside and another outside (Fisher 1958, J. Am. Stat. Assoc. 53, 789, of
/// two groups, by looking at all of them), and deviate more inside. After these, those that deviate less inside, where
/// they explain more: a calibration to the mean leaves least where the cause is. Beams at edges do not take part.
[[nodiscard]] std::vector<Sector> sectorsIn(const Replay& replay, const std::vector<ResidualTable>& tables);

}  // namespace gap
