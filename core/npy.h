#pragma once

#include <filesystem>
#include <vector>

namespace core {

/// The numbers of a one-dimensional NumPy array file (`.npy`, versions 1 to 3; little-endian floats and integers).
/// Throws InputError for anything else. Source: NumPy Enhancement Proposal 1, numpy.lib.format.
[[nodiscard]] std::vector<double> readNpy(const std::filesystem::path& file);

}  // namespace core
