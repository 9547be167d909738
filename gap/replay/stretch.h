#pragma once

#include "model/geometry/hits.h"

namespace gap {

/// How far apart the nearest and the farthest point are that a beam meets; -inf if it meets none.
[[nodiscard]] double stretchOf_m(const model::HitsOfBeam& hits);

/// Whether a surface is so oblique to a beam that echoes of neighbouring sub-rays lie farther apart than `most_m`: then
/// they are echoes of their own, where the surface returns one. Sub-rays without power do not count.
[[nodiscard]] bool isTornApart(const model::HitsOfBeam& hits, const model::SubRays& rays, double most_m);

}  // namespace gap
