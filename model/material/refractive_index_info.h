#pragma once

#include <filesystem>

#include "model/material/refractive_index.h"

namespace model {

/// A YAML file of refractiveindex.info: wavelengths in micrometres. Throws InputError with the line.
[[nodiscard]] OpticalConstants readRefractiveIndexInfo(const std::filesystem::path& file);

}  // namespace model
