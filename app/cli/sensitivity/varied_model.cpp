#include "app/cli/sensitivity/varied_model.h"

#include <algorithm>
#include <array>

#include "core/error.h"
#include "model/sensor/sensor_profile.h"

namespace app {

namespace {

using nlohmann::json;

template <std::size_t N>
bool liesBelow(const std::string& pointer, const std::array<const char*, N>& places) {
  return std::any_of(places.begin(), places.end(),
                     [&pointer](const char* place) { return pointer.starts_with(place); });
}

bool isInModel(const std::string& pointer) {
  return liesBelow(pointer, std::array{"/effects/", "/sensor/", "/sensors/", "/rays_per_beam/"});
}

bool isInExperiment(const std::string& pointer) {
  return liesBelow(pointer, std::array{"/environment/", "/materials/", "/scene/"});
}

core::InputError noSuchNumber(const std::string& pointer, const std::filesystem::path& file, std::string remedy) {
  return {{.file = file, .item = pointer}, "is no number that can be varied.", std::move(remedy)};
}

json::json_pointer parsed(const std::string& pointer) {
  try {
    return json::json_pointer(pointer);
  } catch (const json::exception&) {
    throw core::InputError({.item = pointer}, "is no JSON Pointer.",
                           "Write /effects/NAME/PARAMETER; '~' is ~0 and '/' in a name is ~1.");
  }
}

void checkInModel(const std::string& pointer, const model::LidarModel& model) {
  const json::json_pointer place = parsed(pointer);
  const bool parameter_of_effect = pointer.starts_with("/effects/") && model.json.contains(place.parent_pointer()) &&
                                   model.json.at(place.parent_pointer()).is_object();
  const bool absent = !model.json.contains(place);
  if (absent && parameter_of_effect) return;  // it has its default; the model refuses a name that it does not know
  if (!absent && (model.json.at(place).is_number() || (parameter_of_effect && model.json.at(place).is_null()))) return;
  throw noSuchNumber(pointer, model.file,
                     pointer.starts_with("/effects/") ? "Switch the effect on in the model file; 'fidelis effects' "
                                                        "lists effects and their parameters."
                                                      : "Name a number below /sensor, /sensors or /rays_per_beam.");
}

void checkInExperiment(const std::string& pointer, const model::Experiment& experiment) {
  const json::json_pointer place = parsed(pointer);
  if (experiment.json.contains(place)) {
    const json& value = experiment.json.at(place);
    if (value.is_number() || value.is_null()) return;
  }
  throw noSuchNumber(pointer, experiment.file, "Name a number below /environment, /materials or /scene.");
}

}  // namespace

VariedModel::VariedModel(model::Experiment experiment, model::LidarModel model, std::vector<std::string> pointers)
    : experiment_(std::move(experiment)), model_(std::move(model)), pointers_(std::move(pointers)) {
  model::writeOutSensors(model_.json, model_.file);
  for (const std::string& pointer : pointers_) {
    if (isInModel(pointer)) {
      checkInModel(pointer, model_);
    } else if (isInExperiment(pointer)) {
      checkInExperiment(pointer, experiment_);
    } else {
      throw core::InputError({.item = pointer}, "lies where nothing can be varied.",
                             "Name a number below /effects, /sensor, /sensors or /rays_per_beam of the model, or below "
                             "/environment, /materials or /scene of the experiment.");
    }
  }
}

VariedModel::Variant VariedModel::at(std::span<const double> values) const {
  json model_json = model_.json;
  Variant variant{.experiment = experiment_, .model = {}};
  for (std::size_t i = 0; i < pointers_.size(); ++i) {
    if (isInModel(pointers_[i])) {
      model_json[json::json_pointer(pointers_[i])] = values[i];
      continue;
    }
    const json step{{"op", "replace"}, {"path", pointers_[i]}, {"value", values[i]}};
    for (model::Sample& sample : variant.experiment.samples) sample.patch.push_back(step);
  }
  variant.model = model::parseModel(std::move(model_json), model_.file);
  return variant;
}

}  // namespace app
