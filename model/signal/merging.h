#pragma once

#include <cstddef>
#include <vector>

#include "model/effects/effect.h"
#include "model/signal/waveform.h"

namespace model {

/// Stretches whose peaks lie closer than the separation are one echo, each compared with the one before it: from the
/// first rise to the last fall, with the highest peak (formats.md section 3, step 4). Leaves them in order of range.
void mergeNearStretches(std::vector<Stretch>& stretches, double separation_m);

/// What the sensor reports of a stretch above its threshold, before noise and rounding (step 5).
[[nodiscard]] Echo echoOf(const Stretch& stretch, RangeMode mode);

/// Echoes that no light of this sensor caused (a foreign lidar's pulses, crossings of noise) are stretches above the
/// threshold like all others: one that is nearer to an earlier echo than the separation is one with it. Those from
/// `first` on came in; what is merged into another has the fate kMerged.
void mergeIntruders(std::vector<Echo>& echoes, std::size_t first, const DetectionStage& stage);

}  // namespace model
