#pragma once

#include <span>

#include "gap/distance/comparison.h"
#include "gap/replay/replay.h"

namespace gap {

/// How far a simulation is from the measurement in what neither expects: detections where the geometry has no surface
/// (false alarms, crosstalk, backscatter). Compared are detections per frame over groups of beams of every sample, and
/// over all beams the mean and the spread of every channel: how strong and how far such echoes are tells who makes
/// them. Where they are many, of every sample by itself; where they are few, of all such samples of a sensor together,
/// for six echoes have no mean. Robust standardised differences as in discrepancy.h. Beams at edges have a floor of
/// their own: which of two surfaces they meet is known no better than the reference.
[[nodiscard]] double extraDiscrepancy(const Replay& replay, std::span<const Comparison> comparisons, Part part);

}  // namespace gap
