#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/progress.h"
#include "model/experiment.h"
#include "model/lidar_model.h"

namespace model {

/// One sample at its nominal values (no offsets, or all zero) or at a corner of its epistemic box.
struct WantedRun {
  std::size_t sample = 0;
  EpistemicOffsets offsets;
};

/// What a model that is not ours reported.
struct ExternalRun {
  core::Detections detections;
  int frames = 0;
};

/// Asks models that are not ours. Every answer of a command is kept and given again to the same question (package,
/// command, seed), so keep one of these no longer than the program behind it stays the same: for one session of tests.
///
/// A command gets an experiment package in a folder of its own that holds all wanted runs as samples: patch and offsets
/// applied, sensor profile written out, no measurements in it. A sample at nominal values keeps its id, corner k has
/// the id "ID@k". Each sample's `measurements` names the file that the command is to write below the output folder; any
/// format of core/detection_files will do, and a file of the same name with another ending too.
class ExternalRuns {
 public:
  /// In the order of `wanted`. Throws InputError that names the model file and shows the program's last words: not
  /// found, exit status, signal, time limit, files missing or wrong. Throws Cancelled, and ends the program.
  std::vector<ExternalRun> run(const Experiment& experiment, const LidarModel& model, std::span<const WantedRun> wanted,
                               std::uint64_t seed, core::Progress& progress);

 private:
  std::map<std::string, std::vector<ExternalRun>> kept_;
};

/// One run without keeping it and without a person who could stop it; `seed` overrides the model's.
[[nodiscard]] ExternalRun externalRun(const Experiment& experiment, const LidarModel& model, const WantedRun& wanted,
                                      std::optional<std::uint64_t> seed);

/// Every sample at its nominal values, in one go; nothing if the model is the built-in lidar.
[[nodiscard]] std::vector<ExternalRun> nominalRuns(const Experiment& experiment, const LidarModel& model,
                                                   std::optional<std::uint64_t> seed, core::Progress& progress);

/// The runs that a model can give of a sample: nominal values and all corners; of a recording only what it holds.
/// Throws InputError if some corners are recorded and others not.
[[nodiscard]] std::vector<EpistemicOffsets> cornersOf(const LidarModel& model, const Sample& sample);

/// Files that a result of the model rests on beside the model file: those that its command names, or the recorded ones.
[[nodiscard]] std::vector<std::filesystem::path> filesOf(const LidarModel& model);

/// Throws InputError unless the model is the built-in lidar; `who` is what needs it ("the diagnosis").
void requireBuiltIn(const LidarModel& model, const std::string& who);

}  // namespace model
