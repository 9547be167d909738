#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/withheld/generator/package.h"
#include "tests/support/paths.h"

namespace small_world {

/// A scanner of four rows by 21 columns without noise and without steps, before a board square to it.
[[nodiscard]] nlohmann::json sensor();
/// One board of reflectivity 0.5, 40 m by 40 m, in a sample for each range.
[[nodiscard]] nlohmann::json experiment(const std::vector<double>& ranges_m, int frames = 1);
[[nodiscard]] nlohmann::json model(const nlohmann::json& effects);

/// Peak power of the board square to the beam, without any effect. [W]
[[nodiscard]] double boardPower_w(double range_m);

using Table = std::map<std::string, std::vector<double>>;

/// What the generator makes of the first sample (column → values), in process.
[[nodiscard]] Table generated(const nlohmann::json& experiment, const nlohmann::json& model,
                              const nlohmann::json& truth = {});
[[nodiscard]] Table parsed(const std::string& csv);

}  // namespace small_world
