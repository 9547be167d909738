#pragma once

#include <filesystem>
#include <vector>

namespace model {

/// Throws InputError if a face of a glTF or GLB names a vertex that does not exist (assimp only leaves such faces out).
/// Reads triangles whose indices lie in the GLB itself, in a file beside it or in a data URI; what else is wrong with
/// the file, its reader says.
void checkGltfIndices(const std::filesystem::path& file);

/// The buffers that a glTF keeps in files of their own.
[[nodiscard]] std::vector<std::filesystem::path> buffersOfGltf(const std::filesystem::path& file);

}  // namespace model
