#include "model/lidar_model.h"

#include <algorithm>

#include "core/error.h"
#include "core/text.h"

namespace model {

namespace {

std::vector<std::string> effectNames() {
  std::vector<std::string> names;
  for (const EffectEntry& entry : allEffects()) names.push_back(entry.info.name);
  return names;
}

std::vector<std::string> readSensorsOf(core::JsonObject& effect, const LidarModel& model) {
  const std::vector<std::string> sensors = effect.texts("sensors");
  for (const std::string& sensor : sensors) {
    if (model.sensors.count(sensor) == 0) {
      effect.fail("sensors", "names '" + sensor + "', which is no sensor of this model.",
                  "Name some of the model's 'sensors', or leave the key out for all.");
    }
  }
  return sensors;
}

void readEffects(core::JsonObject effects, LidarModel& model) {
  for (const std::string& name : effects.keys()) {
    if (!findEffect(name)) {
      const std::string nearest = core::nearestName(name, effectNames());
      effects.fail(name, "is not an effect of this library.",
                   nearest.empty() ? "'fidelis effects' lists them." : "Did you mean '" + nearest + "'?");
    }
  }
  for (const EffectEntry& entry : allEffects()) {  // the order of the chain, whatever the order in the file
    if (!effects.has(entry.info.name)) continue;
    core::JsonObject effect = effects.object(entry.info.name);
    const std::vector<std::string> sensors = readSensorsOf(effect, model);
    model.effects.push_back({entry.info.name, readEffectParameters(entry, effect), sensors});
  }
}

void readSensors(core::JsonObject& object, LidarModel& model) {
  if (!object.has("sensors")) {
    model.sensors[""] = resolveSensorProfile(object.raw("sensor"), model.file, "/sensor");
    return;
  }
  core::JsonObject sensors = object.object("sensors");
  for (const std::string& name : sensors.keys()) {
    model.sensors[name] = resolveSensorProfile(sensors.raw(name), model.file, "/sensors/" + name);
  }
}

void readBuiltIn(core::JsonObject& object, LidarModel& model) {
  readSensors(object, model);
  if (object.has("rays_per_beam")) {
    const auto rays = object.numbers("rays_per_beam", 2);
    for (const double count : rays) {
      if (count < 1 || count > 1000 || count != static_cast<int>(count)) {
        object.fail("rays_per_beam", "must be two whole numbers from 1 to 1000.", "Write [horizontal, vertical].");
      }
    }
    model.rays_horizontal = static_cast<int>(rays[0]);
    model.rays_vertical = static_cast<int>(rays[1]);
  }
  if (object.has("effects")) readEffects(object.object("effects"), model);
}

}  // namespace

bool LidarModel::has(const std::string& effect) const {
  return std::any_of(effects.begin(), effects.end(), [&](const ActiveEffect& e) { return e.name == effect; });
}

bool isOn(const std::vector<std::string>& sensors, const std::string& sensor) {
  return sensors.empty() || std::find(sensors.begin(), sensors.end(), sensor) != sensors.end();
}

bool ActiveEffect::actsOn(const std::string& sensor) const { return isOn(sensors, sensor); }

std::vector<ActiveEffect> LidarModel::effectsOf(const std::string& sensor) const {
  std::vector<ActiveEffect> acting;
  std::copy_if(effects.begin(), effects.end(), std::back_inserter(acting),
               [&](const ActiveEffect& effect) { return effect.actsOn(sensor); });
  return acting;
}

const SensorProfile& LidarModel::sensor(const std::string& name) const {
  const auto found = sensors.find(name);
  if (found != sensors.end()) return found->second;
  if (external) {
    throw core::InputError({.file = file}, "is no model of the built-in lidar: it has no sensor.",
                           "Use a model with a sensor, or leave this to simulate, metric and accept.");
  }
  if (sensors.size() == 1 && (name.empty() || sensors.begin()->first.empty())) return sensors.begin()->second;
  throw core::InputError({.file = file, .item = "/sensors"}, "has no sensor '" + name + "'.",
                         "An experiment with several sensors needs a model with sensors of the same names.");
}

LidarModel parseModel(nlohmann::json value, const std::filesystem::path& file) {
  LidarModel model;
  model.file = file;
  model.json = std::move(value);
  core::JsonObject object(model.json, file);
  object.expectFormat("fidelis-model", 1);
  model.id = object.text("id");
  (void)object.textOr("title", "");
  model.seed = static_cast<std::uint64_t>(object.integerOr("seed", 1, {.min = 0}));
  model.external = readExternalModel(object);
  if (!model.external) readBuiltIn(object, model);
  object.finish();
  return model;
}

LidarModel readModel(const std::filesystem::path& file) { return parseModel(core::readJson(file), file); }

LidarModel withEffect(const LidarModel& model, const ActiveEffect& effect) {
  LidarModel changed = model;
  nlohmann::json values = nlohmann::json::object();
  for (const auto& [key, number] : effect.parameters.numbers) values[key] = number;
  for (const auto& [key, text] : effect.parameters.texts) values[key] = text;
  for (const auto& [key, list] : effect.parameters.lists) values[key] = list;
  if (!effect.sensors.empty()) values["sensors"] = effect.sensors;
  changed.json["effects"][effect.name] = values;
  changed.effects.clear();
  for (const EffectEntry& entry : allEffects()) {
    if (entry.info.name == effect.name) {
      changed.effects.push_back(effect);
      continue;
    }
    const auto found = std::find_if(model.effects.begin(), model.effects.end(),
                                    [&](const ActiveEffect& e) { return e.name == entry.info.name; });
    if (found != model.effects.end()) changed.effects.push_back(*found);
  }
  return changed;
}

}  // namespace model
