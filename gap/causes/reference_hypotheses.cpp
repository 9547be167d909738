#include <algorithm>
#include <optional>

#include "gap/causes/kinds.h"

namespace gap {

namespace {

constexpr const char* kYaw = "yaw_pitch_roll_deg/0";

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

/// The number of an object in the scenes; none if another has it anywhere.
std::optional<std::size_t> numberOfObject(const Replay& replay, const std::string& id) {
  std::optional<std::size_t> number;
  for (const ReplaySample& sample : replay.samples()) {
    for (std::size_t i = 0; i < sample.scene.objects.size(); ++i) {
      if (sample.scene.objects[i].id != id) continue;
      if (number.value_or(i) != i) return std::nullopt;
      number = i;
    }
  }
  const bool alone = std::all_of(replay.samples().begin(), replay.samples().end(), [&](const ReplaySample& sample) {
    return sample.scene.objects.size() <= *number || sample.scene.objects[*number].id == id;
  });
  return alone ? number : std::nullopt;
}

/// Whether the experiment, or the patch of any sample, gives a quantity.
bool isRecorded(const Replay& replay, const std::string& pointer) {
  return std::any_of(replay.samples().begin(), replay.samples().end(), [&](const ReplaySample& sample) {
    return model::recordedIn(replay.experiment(), *sample.sample).contains(nlohmann::json::json_pointer(pointer));
  });
}

}  // namespace

void addReferenceHypotheses(const Replay& replay, const std::vector<std::string>& objects,
                            std::vector<Hypothesis>& list) {
  constexpr double kFarthest_m = 1.5, kMost_deg = 15.0;
  std::vector<std::string> setups;
  for (const SetUp& setup : setupsOf(replay)) setups.push_back(setup.name);
  for (const std::string& object : objects) {
    const std::optional<std::size_t> number = numberOfObject(replay, object);
    if (!number) continue;
    const std::string root = "/scene/" + std::to_string(*number) + "/pose/";
    for (const char* axis : {"position_m/0", "position_m/1"}) addReference(root + axis, "m", kFarthest_m, setups, list);
    if (isRecorded(replay, root + kYaw)) addReference(root + kYaw, "deg", kMost_deg, setups, list);
  }
}

}  // namespace gap
