#pragma once

#include <cstdint>
#include <span>

#include "core/random.h"
#include "gap/distance/comparison.h"
#include "gap/replay/replay.h"

namespace gap {

/// Moves the simulated surfaces to where the reference may stand within its epistemic intervals, and echoes that no
/// surface makes within theirs (Tolerance), such that they fit the measurement best; samples of one set-up share their
/// offsets. A random effect: an offset o is taken as normally distributed with the interval's standard deviation σ
/// (width / √12), cut off at its ends. Quantities that the world itself moves set-up by set-up are left alone. Returns
/// Σ o²/(2σ²), what the offsets cost in the units of `discrepancy`. Ranges, intensities and echo pulse widths move to
/// first order; of echoes that no surface makes, ranges alone.
double settle(const Replay& replay, const World& world, std::span<Comparison> comparisons, Part part);

/// Where a quantity stands, within what is recorded of it, in a world drawn at random from the same distribution.
[[nodiscard]] double drawnOffset(const Tolerance& tolerance, core::Random& random);

/// Moves the same as the reference may have stood: by drawn offsets, one for the samples of a set-up and
/// each set-up its own, also where set-ups are drawn one by one.
void scatter(const Replay& replay, const World& world, std::span<Comparison> comparisons, std::uint64_t seed);

}  // namespace gap
