#pragma once

#include <cstdint>
#include <filesystem>

namespace model {

/// Memory that reading one mesh may take. [byte]
inline constexpr double kMostMemory_bytes = 8e9;

/// What can be known of a mesh file before a reader allocates for it. Throws InputError if it does not exist, has
/// another ending than .obj, .ply, .stl, .gltf, .glb, is shorter than its header promises (PLY, binary STL, GLB), ends
/// without its last word (text STL), or is so big that reading it would take more than kMostMemory_bytes.
void checkMeshFile(const std::filesystem::path& file);

/// Throws InputError with the estimate if so many triangles are more than memory is for.
void checkTriangleCount(const std::filesystem::path& file, std::uint64_t triangles);

}  // namespace model
