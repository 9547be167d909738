#pragma once

#include <nlohmann/json.hpp>

#include "model/simulate.h"

/// Two parked cars on a level street, seen by a noise-free scanner 1.5 m above it.
namespace test_objects {

using nlohmann::json;

inline constexpr double kColumn_rad = 0.2 * 3.14159265358979323846 / 180.0;  ///< from beam to beam

/// 30 layers from -12° to 2.5°, azimuth ±40° in steps of 0.2°; single central rays, ranges not rounded.
[[nodiscard]] json sensor();
/// 4.5 m by 1.8 m by 1.5 m, standing on the street.
[[nodiscard]] json car(const std::string& id, double x_m, double y_m, double yaw_deg);
/// The street with a car at (15, -4), turned by 20° (`near`), and one at (25, 5) that stands straight (`far`); `frames`
/// frames.
[[nodiscard]] json streetJson(int frames = 5);
[[nodiscard]] json modelJson();

[[nodiscard]] model::Experiment experimentOf(const json& value);
[[nodiscard]] core::Detections fire(const model::Experiment& experiment);

}  // namespace test_objects
