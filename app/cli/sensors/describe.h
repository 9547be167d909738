#pragma once

#include <iosfwd>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "model/sensor/link_budget.h"
#include "model/sensor/plausibility.h"

namespace app::sensors {

/// A profile with what follows from it.
struct Description {
  model::SensorProfile profile;
  std::vector<model::Finding> findings;
  std::vector<model::LinkBudgetRow> budget;
};

/// `name` is the id of a shipped profile, or a file.
[[nodiscard]] model::SensorProfile profileOf(const std::string& name);
[[nodiscard]] Description describe(model::SensorProfile profile);
[[nodiscard]] bool hasError(const Description& description);

void print(std::ostream& out, const Description& description);

/// What the list says about a profile.
[[nodiscard]] nlohmann::ordered_json summary(const model::SensorProfile& profile);
[[nodiscard]] nlohmann::ordered_json toJson(const Description& description);

/// "1 layer", "4 layers".
[[nodiscard]] std::string counted(std::size_t count, const std::string& noun);

/// The beams of a frame as SVG.
[[nodiscard]] std::string picture(const model::SensorProfile& profile);

}  // namespace app::sensors
