#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/effects/effect.h"
#include "model/external/external_model.h"

namespace model {

/// Whether what is on these sensors, of which none named means all, is on this one.
[[nodiscard]] bool isOn(const std::vector<std::string>& sensors, const std::string& sensor);

/// One effect that is switched on.
struct ActiveEffect {
  std::string name;
  EffectParameters parameters;
  std::vector<std::string> sensors;  ///< on which alone it acts; empty: on all

  [[nodiscard]] bool actsOn(const std::string& sensor) const;
};

/// The simulation model under test (formats.md section 4): sensor, sampling and effects. An effect not listed is off.
struct LidarModel {
  std::filesystem::path file;
  std::string id;
  std::map<std::string, SensorProfile> sensors;  ///< by name; "" if there is one
  int rays_horizontal = 1;
  int rays_vertical = 1;
  std::uint64_t seed = 1;
  std::vector<ActiveEffect> effects;      ///< in the order of the signal chain
  nlohmann::json json;                    ///< as read
  std::optional<ExternalModel> external;  ///< a command or a recording in place of all of the above but id and seed

  [[nodiscard]] bool has(const std::string& effect) const;
  /// The effects that act on a sensor.
  [[nodiscard]] std::vector<ActiveEffect> effectsOf(const std::string& sensor) const;
  /// Throws InputError if the model has no sensor of that name, or is external.
  [[nodiscard]] const SensorProfile& sensor(const std::string& name) const;
};

[[nodiscard]] LidarModel readModel(const std::filesystem::path& file);
[[nodiscard]] LidarModel parseModel(nlohmann::json json, const std::filesystem::path& file);

/// The model with one more effect (or with other parameters of one that it has).
[[nodiscard]] LidarModel withEffect(const LidarModel& model, const ActiveEffect& effect);

}  // namespace model
