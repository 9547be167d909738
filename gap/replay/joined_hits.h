#pragma once

#include <cstdint>
#include <vector>

#include "model/geometry/hits.h"

namespace gap {

/// Joins hits of a beam that lie on one object within a small part of the pulse's width, and came on the same way (the
/// same panes and mirrors); the hits of the beams
/// `replaced` are those of `denser`, which holds just them, in order.
[[nodiscard]] model::BeamHits joined(const model::BeamHits& hits, const std::vector<std::uint32_t>& replaced,
                                     const model::BeamHits& denser, double range_bin_m, double left_bin_rad);

}  // namespace gap
