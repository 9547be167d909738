#include "model/effects/effect.h"

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
  object.finish();
  return parameters;
}

}  // namespace model
