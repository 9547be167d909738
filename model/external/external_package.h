#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "model/external/external_runs.h"

namespace model {

/// The id of a run as a sample of its own: "r10", "r10@1" … in the order of epistemicCorners.
[[nodiscard]] std::string idOf(const Sample& sample, const EpistemicOffsets& offsets);

/// experiment.json for a command, see ExternalRuns. Sample i is wanted[i].
[[nodiscard]] nlohmann::json externalPackage(const Experiment& experiment, std::span<const WantedRun> wanted,
                                             std::uint64_t seed);

/// Writes it with the meshes and beams that it refers to.
void writeExternalPackage(const Experiment& experiment, std::span<const WantedRun> wanted, const nlohmann::json& json,
                          const std::filesystem::path& folder);

}  // namespace model
