#pragma once

#include <cstddef>
#include <vector>

#include "model/effects/effect.h"

namespace model {

/// Echoes that no light of this sensor caused (a foreign lidar's pulses, crossings of noise) are stretches above the
/// threshold like all others: one that is nearer to an earlier echo than the separation is one echo with it, from the
/// first rise to the last fall, with the higher peak (formats.md section 3, step 4). Those from `first` on came in;
/// what is merged into another has the fate kMerged.
void mergeIntruders(std::vector<Echo>& echoes, std::size_t first, const DetectionStage& stage);

}  // namespace model
