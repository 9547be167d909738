#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "acceptance/expression.h"
#include "acceptance/sample_values.h"
#include "core/progress.h"

namespace acceptance {

/// Remarks on limits of d_avm and d_cavm that not even a perfect model would keep in half of all repetitions: two
/// samples of one distribution are never equal (metrics/resampling/permutation_floor.h). Such a test judges the amount
/// of data, not the model. The floor is drawn detection by detection; detections that share errors raise it further, so
/// a remark is never too much.
[[nodiscard]] std::vector<std::string> unattainableLimits(const std::vector<Relation>& relations,
                                                          const Distributions& distributions, const std::string& unit,
                                                          std::uint64_t seed, core::Progress& progress);

}  // namespace acceptance
