#include "model/scene/mesh.h"

#include <algorithm>
#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/mesh.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <cmath>
#include <new>

#include "core/error.h"
#include "core/text.h"
#include "model/scene/gltf_file.h"
#include "model/scene/mesh_file.h"

namespace model {

namespace {

bool isGltf(const std::filesystem::path& file) {
  const std::string ending = core::lowerCase(file.extension().string());
  return ending == ".gltf" || ending == ".glb";
}

double area(const Vector3& a, const Vector3& b, const Vector3& c) {
  const Vector3 u = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  return std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2.0;
}

/// Walks the scene graph and collects every mesh where its node puts it.
class Collector {
 public:
  Collector(const Mesh& mesh, const aiScene& scene) : mesh_(mesh), scene_(scene), y_up_(isGltf(mesh.file)) {}

  Triangles collect() {
    walk(*scene_.mRootNode, aiMatrix4x4());
    if (faces_seen_ == 0) {
      throw core::InputError({.file = mesh_.file}, "the mesh has no faces.",
                             "Export triangles or polygons: points and lines reflect nothing.");
    }
    if (triangles_.faces.empty()) {
      throw core::InputError({.file = mesh_.file}, "the mesh has only faces without area.",
                             "Its vertices coincide or lie on lines; check the export, and its unit and precision.");
    }
    return std::move(triangles_);
  }

 private:
  void walk(const aiNode& node, const aiMatrix4x4& parent) {
    const aiMatrix4x4 here = parent * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) add(*scene_.mMeshes[node.mMeshes[i]], here);
    for (unsigned i = 0; i < node.mNumChildren; ++i) walk(*node.mChildren[i], here);
  }

  void add(const aiMesh& part, const aiMatrix4x4& place) {
    checkTriangleCount(mesh_.file, triangles_.faces.size() + part.mNumFaces);  // nodes may repeat a part very often
    const auto first = static_cast<std::uint32_t>(triangles_.vertices.size());
    for (unsigned v = 0; v < part.mNumVertices; ++v) {
      const aiVector3D p = place * part.mVertices[v];
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
        throw core::InputError({.file = mesh_.file}, "the mesh has a vertex whose coordinates are not finite numbers.",
                               "Remove NaN and infinity; export it again.");
      }
      const Vector3 own = y_up_ ? Vector3{p.z, p.x, p.y} : Vector3{p.x, p.y, p.z};
      triangles_.vertices.push_back({own[0] * mesh_.scale, own[1] * mesh_.scale, own[2] * mesh_.scale});
    }
    for (unsigned f = 0; f < part.mNumFaces; ++f) addFace(part.mFaces[f], part.mNumVertices, first);
  }

  void addFace(const aiFace& face, unsigned vertices, std::uint32_t first) {
    if (face.mNumIndices != 3) return;  // points and lines reflect nothing
    ++faces_seen_;
    std::array<std::uint32_t, 3> corner{};
    for (std::size_t k = 0; k < 3; ++k) {
      if (face.mIndices[k] >= vertices) {
        throw core::InputError({.file = mesh_.file}, "the mesh has a face that names a vertex which does not exist.",
                               "The file is damaged; export it again.");
      }
      corner[k] = first + face.mIndices[k];
    }
    const auto& v = triangles_.vertices;
    if (area(v[corner[0]], v[corner[1]], v[corner[2]]) > 0.0) triangles_.faces.push_back(corner);
  }

  const Mesh& mesh_;
  const aiScene& scene_;
  bool y_up_;
  std::uint64_t faces_seen_ = 0;
  Triangles triangles_;
};

const aiScene& imported(Assimp::Importer& importer, const std::filesystem::path& file) {
  // Only positions and faces count; without normals and the like, equal corners of neighbours become one vertex.
  importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS,
                              aiComponent_NORMALS | aiComponent_TANGENTS_AND_BITANGENTS | aiComponent_COLORS |
                                  aiComponent_TEXCOORDS | aiComponent_BONEWEIGHTS | aiComponent_ANIMATIONS |
                                  aiComponent_TEXTURES | aiComponent_LIGHTS | aiComponent_CAMERAS);
  const aiScene* scene = importer.ReadFile(file.string(), aiProcess_ValidateDataStructure | aiProcess_RemoveComponent |
                                                              aiProcess_Triangulate | aiProcess_JoinIdenticalVertices);
  if (!scene || !scene->mRootNode || scene->mNumMeshes == 0) {
    std::string why = importer.GetErrorString();
    if (why.empty()) why = "it has no faces";
    throw core::InputError({.file = file}, "the mesh cannot be read: " + why + ".",
                           "Use OBJ, PLY, STL or glTF with triangles or polygons.");
  }
  return *scene;
}

}  // namespace

Triangles readMesh(const Mesh& mesh) {
  checkMeshFile(mesh.file);
  if (isGltf(mesh.file)) checkGltfIndices(mesh.file);
  try {
    Assimp::Importer importer;
    return Collector(mesh, imported(importer, mesh.file)).collect();
  } catch (const std::bad_alloc&) {
    throw core::InputError({.file = mesh.file}, "the mesh needs more memory than there is.",
                           "Reduce its number of triangles.");
  }
}

std::vector<std::filesystem::path> filesOfMesh(const std::filesystem::path& file) {
  std::vector<std::filesystem::path> files{file};
  if (!isGltf(file) || !std::filesystem::is_regular_file(file)) return files;
  const auto buffers = buffersOfGltf(file);
  files.insert(files.end(), buffers.begin(), buffers.end());
  return files;
}

const Triangles& MeshLibrary::of(const Mesh& mesh) {
  const std::pair key{mesh.file.lexically_normal(), mesh.scale};
  const auto known = meshes_.find(key);
  return known != meshes_.end() ? known->second : meshes_.emplace(key, readMesh(mesh)).first->second;
}

}  // namespace model
