#include <algorithm>

#include "gap/causes/kinds.h"

namespace gap {

using nlohmann::json;

namespace {

/// A number of the model file that is wrong; `value` says its unit, range and what is recorded.
Hypothesis modelParameter(const std::string& pointer, const FreeParameter& value) {
  Hypothesis hypothesis;
  hypothesis.kind = CauseKind::kParameter;
  hypothesis.name = pointer;
  hypothesis.parameters = {value};
  hypothesis.apply = [pointer](World& world, const std::vector<double>& values) {
    json changed = world.model.json;
    changed[json::json_pointer(pointer)] = values[0];
    const model::LidarModel parsed = model::parseModel(changed, world.model.file);
    world.model = parsed;
  };
  return hypothesis;
}

void addModelParameters(const Replay& replay, std::vector<Hypothesis>& list) {
  const json& model = replay.baseline().model.json;
  const auto add = [&](const std::string& pointer, const char* unit, double factor) {
    const json::json_pointer place(pointer);
    if (!model.contains(place) || !model.at(place).is_number()) return;
    const double value = model.at(place).get<double>();
    if (value > 0.0)
      list.push_back(modelParameter(pointer, {"value", unit, value / factor, value * factor, true, value}));
  };
  std::vector<std::string> roots;
  if (model.contains("sensor")) roots.push_back("/sensor");
  if (model.contains("sensors")) {
    for (const auto& item : model["sensors"].items()) roots.push_back("/sensors/" + item.key());
  }
  for (const std::string& root : roots) {
    add(root + "/emitter/peak_power_w", "W", 4.0);
    add(root + "/emitter/pulse_fwhm_ns", "ns", 3.0);
    add(root + "/receiver/noise_w", "W", 10.0);
    add(root + "/receiver/threshold_w", "W", 5.0);
    add(root + "/detection/range_noise_m", "m", 20.0);
    add(root + "/detection/epw_noise_m", "m", 20.0);
    if (replay.baseline().model.has("beam-divergence")) {
      add(root + "/emitter/divergence_rad/horizontal", "rad", 3.0);
      add(root + "/emitter/divergence_rad/vertical", "rad", 3.0);
    }
  }
  for (const model::ActiveEffect& effect : replay.baseline().model.effects) {
    for (const auto& [name, value] : effect.parameters.numbers) {
      const auto& parameters = model::findEffect(effect.name)->info.parameters;
      const auto info =
          std::find_if(parameters.begin(), parameters.end(), [&](const auto& p) { return p.name == name; });
      if (info == parameters.end()) continue;
      const double low = std::max(info->min, value > 0 ? value / 10 : info->min);
      const double high = std::min(info->max, value > 0 ? value * 10 : info->max);
      list.push_back(
          modelParameter("/effects/" + effect.name + "/" + name, {"value", info->unit, low, high, false, value}));
    }
  }
}

void addMaterials(const Replay& replay, const std::set<std::int32_t>& objects, std::vector<Hypothesis>& list) {
  const model::Scene scene = model::situationOf(replay.experiment(), *replay.samples().front().sample).scene;
  std::set<std::size_t> materials;
  for (const std::int32_t object : objects) materials.insert(scene.objects[static_cast<std::size_t>(object)].material);
  for (const std::size_t index : materials) {
    const model::Material& material = scene.materials[index];
    if (material.reflectivity <= 0.0) continue;
    Hypothesis hypothesis;
    hypothesis.kind = CauseKind::kParameter;
    hypothesis.name = "/materials/" + material.name + "/reflectivity";
    hypothesis.parameters = {{"value", "", material.reflectivity / 5.0, std::min(1.0, 5.0 * material.reflectivity),
                              true, material.reflectivity}};
    const std::string name = material.name;
    hypothesis.apply = [name](World& world, const std::vector<double>& values) {
      world.reflectivity[name] = values[0];
    };
    list.push_back(std::move(hypothesis));
  }
}

}  // namespace

void addParameterHypotheses(const Replay& replay, const std::set<std::int32_t>& objects,
                            std::vector<Hypothesis>& list) {
  addModelParameters(replay, list);
  addMaterials(replay, objects, list);
}

}  // namespace gap
