#pragma once

#include <filesystem>
#include <string>

#include "model/experiment.h"

namespace model {

/// Copies what a package refers to besides the measurements (meshes, beams) into `folder`, keeping relative places.
/// Throws InputError if something lies outside the package.
void copyReferenced(const Experiment& experiment, const std::filesystem::path& folder);

/// A sample's id as the name of a file: what is not a letter, digit, '-', '_' or '.' becomes '_'.
[[nodiscard]] std::string fileNameOf(std::string id);

}  // namespace model
