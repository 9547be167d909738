#include <numeric>

#include "gap/causes/kinds.h"

namespace gap {

namespace {

/// A quantity that is off by the same everywhere, and one that is off by something else in every set-up.
void addReference(const std::string& pointer, const std::string& unit, double most,
                  const std::vector<std::string>& setups, std::vector<Hypothesis>& list) {
  Hypothesis constant;
  constant.kind = CauseKind::kReference;
  constant.name = pointer;
  constant.parameters = {{"offset", unit, -most, most, false, 0.0}};
  constant.apply = [pointer](World& world, const std::vector<double>& values) {
    world.references.push_back({pointer, values[0], {}});
  };
  list.push_back(constant);
  if (setups.size() < 2) return;
  Hypothesis varying = constant;
  varying.variant = "per set-up";
  varying.per_setup = true;
  varying.parameters.clear();
  for (const std::string& setup : setups) varying.parameters.push_back({setup, unit, -most, most, false, 0.0});
  varying.apply = [pointer, setups](World& world, const std::vector<double>& values) {
    ReferenceOffset offset{pointer, 0.0, {}};
    for (std::size_t i = 0; i < setups.size(); ++i) offset.by_setup[setups[i]] = values[i];
    world.references.push_back(std::move(offset));
  };
  list.push_back(std::move(varying));
}

}  // namespace

void addReferenceHypotheses(const Replay& replay, const std::set<std::int32_t>& objects,
                            std::vector<Hypothesis>& list) {
  constexpr double kFarthest_m = 1.5, kMost_deg = 15.0;
  std::vector<std::size_t> everything(replay.samples().size());
  std::iota(everything.begin(), everything.end(), std::size_t{0});
  const std::vector<std::string> setups = setupsOf(replay, everything);
  for (const std::int32_t index : objects) {
    const auto& pose = replay.experiment().json["scene"][static_cast<std::size_t>(index)]["pose"];
    const std::string root = "/scene/" + std::to_string(index) + "/pose/";
    for (const char* axis : {"0", "1"}) {
      addReference(root + "position_m/" + axis, "m", kFarthest_m, setups, list);
    }
    if (pose.contains("yaw_pitch_roll_deg"))
      addReference(root + "yaw_pitch_roll_deg/0", "deg", kMost_deg, setups, list);
  }
}

}  // namespace gap
