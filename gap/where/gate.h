#pragma once

#include "gap/where/where.h"

namespace gap {

/// From the residuals of existence, where a surface is expected: the range that parts best what is lost from
/// what is there, halfway between two cells. Strata are cut at sixteenths of the data, and most of a wall may stand
/// before the gate that cuts its far end.
[[nodiscard]] Gate gateIn(const Replay& replay, const ResidualTable& missing);

}  // namespace gap
