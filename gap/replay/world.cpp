#include "gap/replay/world.h"

#include <algorithm>

#include "core/text.h"

namespace gap {

double ReferenceOffset::of(const std::string& setup) const {
  const auto found = by_setup.find(setup);
  return everywhere + (found == by_setup.end() ? 0.0 : found->second);
}

std::string geometryKey(const World& world, const model::Sample& sample) {
  std::string key;
  for (const model::ActiveEffect& effect : world.model.effects) {
    if (!effect.actsOn(sample.sensor)) continue;
    if (!model::findEffect(effect.name)->info.moves_geometry) continue;
    key += effect.name + "{";
    const auto& power_only = model::findEffect(effect.name)->info.power_only;
    for (const auto& [name, value] : effect.parameters.numbers) {
      const bool moves = std::find(power_only.begin(), power_only.end(), name) == power_only.end();
      key += moves ? name + "=" + core::shortestNumber(value) + ";" : name + ";";
    }
    for (const auto& [name, values] : effect.parameters.lists) {
      key += name + "=[";
      for (const double value : values) key += core::shortestNumber(value) + ",";
      key += "];";
    }
    key += "}";
  }
  const model::AngularSize& beam = world.model.sensor(sample.sensor).emitter.divergence;
  key += core::shortestNumber(beam.horizontal_rad) + "x" + core::shortestNumber(beam.vertical_rad);
  for (const ReferenceOffset& reference : world.references) {
    const double offset = reference.of(sample.setup);
    if (offset != 0.0) key += "|" + reference.pointer + "+" + core::shortestNumber(offset);
  }
  return key;
}

model::Situation situationIn(const World& world, const model::Experiment& experiment, const model::Sample& sample) {
  model::Sample moved = sample;
  model::EpistemicOffsets offsets;
  moved.epistemic.clear();
  const nlohmann::json recorded = model::recordedIn(experiment, sample);
  for (const ReferenceOffset& reference : world.references) {
    if (!recorded.contains(nlohmann::json::json_pointer(reference.pointer))) continue;  // the object is not there
    moved.epistemic.push_back({reference.pointer, 0.0, 0.0});
    offsets.push_back(reference.of(sample.setup));
  }
  return model::situationOf(experiment, moved, offsets);
}

}  // namespace gap
