#pragma once

#include <string>

#include "model/demonstration/demonstration.h"

namespace app::effects {

/// Draws what an effect does to the detections, SVG Tiny 1.2.
[[nodiscard]] std::string picture(const model::Demonstration& demonstration);

}  // namespace app::effects
