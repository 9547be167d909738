#pragma once

#include "gap/comparison.h"
#include "gap/replay.h"

namespace gap {

/// How far a simulation is from the measurement in what neither expects: detections where the geometry has no surface
/// (false alarms, crosstalk, backscatter). Compared are detections per frame over groups of beams, and over all of them
/// the mean and the spread of every channel: how strong and how far such echoes are tells who makes them. Robust
/// standardised differences as in discrepancy.h. Beams at edges have a floor of their own: which of two surfaces they
/// meet is known no better than the reference.
[[nodiscard]] double extraDiscrepancy(const Replay& replay, const Comparison& comparison, Part part);

}  // namespace gap
