#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/detections.h"

namespace prediction {

/// What an error may depend on and every detection tells by itself: range_m, azimuth_deg, azimuth_rad, elevation_deg,
/// elevation_rad, layer, echo, epw_m, intensity, frame, time_s. The angle of incidence is not among them: a sensor does
/// not know it.
[[nodiscard]] const std::vector<std::string>& detectionQuantities();

/// One value for each detection; absent if it was not recorded. `quantity` is one of detectionQuantities().
[[nodiscard]] std::optional<std::vector<double>> valuesOf(const core::Detections& detections,
                                                          const std::string& quantity);

}  // namespace prediction
