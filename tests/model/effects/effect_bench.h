#pragma once

#include <string>

#include "tests/model/lab.h"

namespace model::lab {

/// A board across the beam and one effect with its parameters (null: none).
[[nodiscard]] inline Case boardWith(double range_m, const std::string& effect = "", json parameters = json::object()) {
  Case setup;
  setup.scene = {board(range_m)};
  if (!effect.empty()) setup.effects[effect] = std::move(parameters);
  return setup;
}

/// Received power with the effect over that without it.
[[nodiscard]] inline double powerRatio(double range_m, const std::string& effect, const json& parameters) {
  return power_w(boardWith(range_m, effect, parameters)) / power_w(boardWith(range_m));
}

/// A board turned by `incidence_deg`.
[[nodiscard]] inline Case slanted(Case setup, double incidence_deg) {
  setup.scene[0]["pose"]["yaw_pitch_roll_deg"] = {incidence_deg, 0, 0};
  return setup;
}

}  // namespace model::lab
