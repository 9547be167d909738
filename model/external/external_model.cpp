#include "model/external/external_model.h"

#include <algorithm>

namespace model {

namespace {

bool names(const std::vector<std::string>& command, const std::string& placeholder) {
  return std::any_of(command.begin(), command.end(),
                     [&](const std::string& word) { return word.find(placeholder) != std::string::npos; });
}

std::vector<std::string> readCommand(core::JsonObject& object) {
  std::vector<std::string> command = object.texts("command");
  if (command.empty() || command.front().empty()) {
    object.fail("command", "names no program.", "Write the program and its arguments, each a text of its own.");
  }
  const bool experiment = names(command, "{experiment}"), out = names(command, "{out}");
  if (experiment != out) {
    object.fail("command", std::string("lacks ") + (experiment ? "{out}" : "{experiment}") + ".",
                "Name {experiment} and {out} both, or neither: then both folders follow the command.");
  }
  if (!experiment) command.insert(command.end(), {"{experiment}", "{out}"});
  return command;
}

ExternalModel read(core::JsonObject& object) {
  ExternalModel model;
  if (object.has("proxy")) {  // for whoever needs a built-in model in its place, out of the file: gap/far/proxy.h
    const nlohmann::json& proxy = object.raw("proxy");
    if (!proxy.is_string() && !proxy.is_object()) {
      object.fail("proxy", "is neither the name of a model file nor an object.",
                  "Name a model file of the built-in lidar, or write its effects here: {\"effects\": {…}}.");
    }
  }
  if (object.has("recorded")) {
    if (object.has("command")) object.fail("recorded", "stands beside /command.", "Keep one of the two.");
    model.recorded = object.file().parent_path() / object.text("recorded");
    return model;
  }
  model.command = readCommand(object);
  model.time_limit_s = object.numberOr("time_limit_s", model.time_limit_s, {.min = 0.0, .max = 1e7, .open_min = true});
  return model;
}

}  // namespace

std::optional<ExternalModel> readExternalModel(core::JsonObject& object) {
  if (!object.has("model") && !object.has("command") && !object.has("recorded")) return std::nullopt;
  for (const char* key : {"sensor", "sensors", "rays_per_beam", "effects"}) {
    if (object.has(key)) {
      object.fail(key, "belongs to the built-in lidar; this model is a command or a recording.",
                  "Remove it: the experiment names the sensor. A built-in model that comes near goes under /proxy.");
    }
  }
  if (!object.has("model")) return read(object);
  core::JsonObject inner = object.object("model");  // "model": {"command": …}, as others may write it
  ExternalModel model = read(inner);
  inner.finish();
  return model;
}

}  // namespace model
