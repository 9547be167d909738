#pragma once

#include <vector>

#include "core/detections.h"
#include "model/scene/pose.h"

namespace objects {

using model::Vector3;

/// Where each detection lies. Frame: ISO 8855, sensor at the origin. [m] The directions must have been recorded.
[[nodiscard]] std::vector<Vector3> pointsOf(const core::Detections& detections);

}  // namespace objects
