#pragma once

#include <optional>

#include "gap/where/residual_tables.h"

namespace gap {

/// The ranges at which the loss of expected echoes begins: what a gate of the receiver would do. [m]
struct Gate {
  std::optional<double> opens_m;   ///< nearer, more echoes are lost than are there; nothing if it is so nowhere
  std::optional<double> closes_m;  ///< the same beyond
  /// The nearest echo of all, where several are expected nearer: a gate within the noise of a wall takes a part of its
  /// echoes. It is the likeliest end of what was cut off.
  std::optional<double> nearest_m;
  std::optional<double> farthest_m;  ///< the same beyond
};

/// From the residuals of existence, where a surface is expected: the range that parts best what is lost from
/// what is there, halfway between two cells. Strata are cut at sixteenths of the data, and most of a wall may stand
/// before the gate that cuts its far end.
[[nodiscard]] Gate gateIn(const Replay& replay, const ResidualTable& missing);

}  // namespace gap
