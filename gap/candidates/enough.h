#pragma once

#include "gap/candidates/candidates.h"

namespace gap {

/// The least share of the gap that a cause explains to be named, where the gap is hardly larger than the noise.
inline constexpr double kWeakGap = 0.40;

/// The share of the gap that a cause must account for to be named.
[[nodiscard]] double enoughToName(const Yardstick& yardstick);
/// The share of the cells' discrepancy that two causes must explain together: whatever is missing, some two of sixty
/// explain a part of it.
[[nodiscard]] double enoughForTwo(const Yardstick& yardstick);

}  // namespace gap
