#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/json_object.h"

namespace model {

/// A model under test that is not the built-in lidar. One of two:
///
///   command    any program that reads an experiment package and writes what the sensor would have reported
///   recorded   an experiment package whose measurements were simulated elsewhere
///
/// In the model file: {"command": ["python3", "my_lidar.py", "{experiment}", "{out}"], "time_limit_s": 300} or
/// {"recorded": "FOLDER"} beside format, version, id and seed. Paths begin at the model file's folder; the command runs
/// there, without a shell.
struct ExternalModel {
  std::vector<std::string> command;  ///< empty if it is recorded
  double time_limit_s = 600.0;       ///< of one run of the command
  std::filesystem::path recorded;    ///< folder or experiment.json; empty if there is a command
};

/// Reads the keys above from a model file; nothing if it is one of the built-in lidar. Throws InputError with JSON
/// Pointer: both or half of them, an empty command, keys of the built-in lidar beside them.
[[nodiscard]] std::optional<ExternalModel> readExternalModel(core::JsonObject& object);

}  // namespace model
