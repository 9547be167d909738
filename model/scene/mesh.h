#pragma once

#include <filesystem>
#include <map>
#include <utility>
#include <vector>

#include "model/scene/triangles.h"

namespace model {

/// Reads OBJ, PLY, STL, glTF or GLB (through assimp); polygons become triangles, the transforms of the file's scene
/// graph are applied, points, lines and faces without area are left out.
///
///   frame  OBJ, PLY and STL say nothing of axes: x, y, z of the file are the shape's own (ISO 8855: forward, left,
///   up).
///          glTF says +z forward, +x left, +y up (glTF 2.0 specification, section 3.4 "Coordinate System and Units"):
///          it is turned, (x, y, z) := (z, x, y) of the file.
///   unit   metres times `scale`; glTF is in metres by its specification, the others are what their maker meant
///
/// Throws InputError, with file and remedy, for a file that is missing, of another format, cut off, without faces or
/// with faces without area only, with coordinates that are not finite, with indices of vertices that do not exist, and
/// for one whose reading would take more memory than kMostMemory_bytes.
[[nodiscard]] Triangles readMesh(const Mesh& mesh);

/// The mesh file and those that it cannot do without (the buffers of a glTF).
[[nodiscard]] std::vector<std::filesystem::path> filesOfMesh(const std::filesystem::path& file);

/// Meshes of one scene: each file is read once for each scale, however many objects show it. Not safe to share between
/// threads while it grows.
class MeshLibrary {
 public:
  /// Stays valid, and at its place in memory, as long as the library: equal meshes have the same address.
  [[nodiscard]] const Triangles& of(const Mesh& mesh);

  [[nodiscard]] std::size_t size() const { return meshes_.size(); }

 private:
  std::map<std::pair<std::filesystem::path, double>, Triangles> meshes_;
};

}  // namespace model
