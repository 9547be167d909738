#include "bench/withheld/generator/world.h"

#include <filesystem>

#include "bench/withheld/generator/bad_input.h"

namespace withheld {

namespace {

Profile sensorOf(const Json& json, const std::string& place, const std::string& profiles) {
  if (!json.is_string()) return readProfile(json, place);
  const std::string file = (std::filesystem::path(profiles) / (json.get<std::string>() + ".json")).string();
  if (!std::filesystem::exists(file)) {
    throw BadInput(place, "'" + json.get<std::string>() + "' is no sensor in " + profiles + ".",
                   "Write the profile itself, or name the folder with --sensors.");
  }
  return readProfile(readJson(file), file + ": ");
}

}  // namespace

World readWorld(const std::string& file, const std::string& profiles) {
  const Json json = readJson(file);
  const std::string place = file + ": ";
  const Fields fields(
      json, place,
      {"format", "version", "id", "title", "source", "sensor", "sensors", "rays_per_beam", "seed", "effects"});
  if (fields.text("format") != "fidelis-model")
    throw BadInput(fields.placeOf("format"), "is not fidelis-model.", "Give a model file.");
  std::map<std::string, Profile> sensors;
  if (const Json* several = fields.find("sensors")) {
    if (!several->is_object())
      throw BadInput(fields.placeOf("sensors"), "is not an object.", "Write {\"name\": profile}.");
    for (const auto& [name, sensor] : several->items()) {
      sensors[name] = sensorOf(sensor, fields.placeOf("sensors") + "/" + name, profiles);
    }
  } else {
    sensors[""] = sensorOf(fields.at("sensor"), fields.placeOf("sensor"), profiles);
  }
  const Json none = Json::object(), *effects = fields.find("effects");
  World world{std::move(sensors), Effects(effects ? *effects : none, fields.placeOf("effects"))};
  const std::string pulse = fields.oneOf("x-pulse", {"gaussian", "measured-like"}, "gaussian");
  world.pulse_rise_share = pulse == "gaussian" ? 0.5 : 0.4;
  world.seed = static_cast<std::uint64_t>(fields.number("seed", 1));
  return world;
}

}  // namespace withheld
