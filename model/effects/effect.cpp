#include "model/effects/effect.h"

#include <cmath>
#include <fmt/format.h>

namespace model {

std::string toString(Stage stage) {
  switch (stage) {
    case Stage::kEmission:
      return "Emission";
    case Stage::kPropagation:
      return "Signal propagation";
    case Stage::kInteraction:
      return "Signal propagation";
    case Stage::kReception:
      return "Reception";
    case Stage::kPreProcessing:
      return "Pre-processing";
    case Stage::kDetection:
      return "Detection identification";
  }
  return "";
}

double EffectParameters::numberOr(const std::string& name, double otherwise) const {
  return number(name).value_or(otherwise);
}

std::optional<double> EffectParameters::number(const std::string& name) const {
  const auto found = numbers.find(name);
  return found == numbers.end() ? std::nullopt : std::optional(found->second);
}

std::string EffectParameters::textOr(const std::string& name, const std::string& otherwise) const {
  const auto found = texts.find(name);
  return found == texts.end() ? otherwise : found->second;
}

std::vector<double> EffectParameters::listOr(const std::string& name, std::vector<double> otherwise) const {
  const auto found = lists.find(name);
  return found == lists.end() ? std::move(otherwise) : found->second;
}

double Reflection::azimuth_rad() const {
  const Vector3 d = direction();
  return std::atan2(d[1], d[0]);
}

const EffectEntry* findEffect(const std::string& name) {
  for (const EffectEntry& entry : allEffects()) {
    if (entry.info.name == name) return &entry;
  }
  return nullptr;
}

EffectParameters readEffectParameters(const EffectEntry& entry, core::JsonObject object) {
  EffectParameters parameters;
  for (const ParameterInfo& info : entry.info.parameters) {
    if (const auto value = object.optionalNumber(info.name, {.min = info.min, .max = info.max})) {
      parameters.numbers[info.name] = *value;
    }
  }
  for (const auto& [name, choices] : entry.texts) {
    if (object.has(name)) parameters.texts[name] = object.choice(name, choices);
  }
  for (const ListInfo& info : entry.lists) {
    if (!object.has(info.name)) continue;
    const std::vector<double> values = object.numbers(info.name, info.count);
    for (const double value : values) {
      if (value < info.min || value > info.max) {
        object.fail(info.name, fmt::format("holds {:g}, outside {:g} … {:g}.", value, info.min, info.max),
                    "Keep every number of the list inside.");
      }
    }
    parameters.lists[info.name] = values;
  }
  object.finish();
  return parameters;
}

}  // namespace model
