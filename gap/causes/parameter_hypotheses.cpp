#include <algorithm>
#include <map>

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
    setNumber(world, pointer, values[0]);
  };
  return hypothesis;
}

/// The number of an active effect, searched up to ten times as large or small as it stands in the model; an azimuth
/// wherever it may be.
FreeParameter aroundRecorded(const model::ParameterInfo& info, double value) {
  constexpr double kTimes = 10.0;
  FreeParameter fitted = declared(info);
  fitted.name = "value";
  fitted.logarithmic = info.logarithmic && value > 0.0;
  const bool by_ratio = value > 0.0 && !fitted.azimuth;
  fitted.low = by_ratio ? std::max(info.min, value / kTimes) : info.min;
  fitted.high = by_ratio ? std::min(info.max, value * kTimes) : info.max;
  fitted.start = value;
  return fitted;
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
  for (const std::string& root : profilesIn(model)) {
    add(root + "/emitter/peak_power_w", "W", 4.0);
    const bool measured_pulse = model.contains(json::json_pointer(root + "/emitter/pulse_shape"));
    if (!measured_pulse) add(root + "/emitter/pulse_fwhm_ns", "ns", 3.0);  // a measured one brings its own width
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
      if (info == parameters.end() || info->seed) continue;
      list.push_back(modelParameter("/effects/" + effect.name + "/" + name, aroundRecorded(*info, value)));
    }
  }
}

void addMaterials(const Replay& replay, const std::vector<std::string>& objects, std::vector<Hypothesis>& list) {
  std::map<std::string, double> reflectivities;
  for (const ReplaySample& sample : replay.samples()) {
    for (const model::SceneObject& object : sample.scene.objects) {
      const model::Material& material = sample.scene.materials[object.material];
      const bool suspected = std::find(objects.begin(), objects.end(), object.id) != objects.end();
      if (suspected && material.reflectivity > 0.0) reflectivities.try_emplace(material.name, material.reflectivity);
    }
  }
  for (const auto& [name, recorded] : reflectivities) {
    Hypothesis hypothesis;
    hypothesis.kind = CauseKind::kParameter;
    hypothesis.name = "/materials/" + name + "/reflectivity";
    hypothesis.parameters = {{"value", "", recorded / 5.0, std::min(1.0, 5.0 * recorded), true, recorded}};
    hypothesis.apply = [material = name](World& world, const std::vector<double>& values) {
      world.reflectivity[material] = values[0];
    };
    list.push_back(std::move(hypothesis));
  }
}

}  // namespace

std::vector<std::string> profilesIn(const json& model, const std::vector<std::string>& sensors) {
  std::vector<std::string> places;
  if (model.contains("sensor")) places.emplace_back("/sensor");
  if (!model.contains("sensors")) return places;
  for (const auto& item : model["sensors"].items())
    if (model::isOn(sensors, item.key())) places.push_back("/sensors/" + item.key());
  return places;
}

void setNumber(World& world, const std::string& pointer, double value) {
  json changed = world.model.json;
  changed[json::json_pointer(pointer)] = value;
  const model::LidarModel parsed = model::parseModel(changed, world.model.file);
  world.model = parsed;
}

void addParameterHypotheses(const Replay& replay, const std::vector<std::string>& objects,
                            std::vector<Hypothesis>& list) {
  addModelParameters(replay, list);
  addMaterials(replay, objects, list);
}

}  // namespace gap
