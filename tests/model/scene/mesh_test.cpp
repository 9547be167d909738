#include "model/scene/mesh.h"

#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <functional>
#include <gtest/gtest.h>
#include <numbers>

#include "model/geometry/ray_tracer.h"
#include "model/scene/mesh_file.h"
#include "tests/model/lab.h"
#include "tests/support/paths.h"

namespace model {
namespace {

using Corners = std::vector<Vector3>;
using Faces = std::vector<std::vector<int>>;

const Vector3 kSize{1.0, 2.0, 3.0};

/// Corners of the box of kSize, numbered by the bits x y z, and its six sides as quadrilaterals seen from outside.
Corners boxCorners() {
  Corners corners;
  for (int i = 0; i < 8; ++i) {
    corners.push_back({kSize[0] * ((i & 1) - 0.5), kSize[1] * ((i >> 1 & 1) - 0.5), kSize[2] * ((i >> 2 & 1) - 0.5)});
  }
  return corners;
}
const Faces kSides{{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};

std::vector<std::array<int, 3>> boxTriangles() {
  std::vector<std::array<int, 3>> triangles;
  for (const auto& side : kSides) {
    triangles.push_back({side[0], side[1], side[2]});
    triangles.push_back({side[0], side[2], side[3]});
  }
  return triangles;
}

std::string objOf(const Corners& corners, const Faces& faces) {
  std::string text;
  for (const auto& v : corners) text += fmt::format("v {} {} {}\n", v[0], v[1], v[2]);
  for (const auto& face : faces) {
    text += "f";
    for (const int corner : face) text += fmt::format(" {}", corner + 1);
    text += "\n";
  }
  return text;
}

std::string plyHeader(const std::string& format) {
  return "ply\nformat " + format +
         " 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
         "element face 6\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string textPly() {
  std::string text = plyHeader("ascii");
  for (const auto& v : boxCorners()) text += fmt::format("{} {} {}\n", v[0], v[1], v[2]);
  for (const auto& f : kSides) text += fmt::format("4 {} {} {} {}\n", f[0], f[1], f[2], f[3]);
  return text;
}

template <typename Value>
void append(std::string& bytes, const Value& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string binaryPly() {
  std::string bytes = plyHeader("binary_little_endian");
  for (const auto& v : boxCorners()) {
    for (const double x : v) append(bytes, static_cast<float>(x));
  }
  for (const auto& f : kSides) {
    append(bytes, std::uint8_t{4});
    for (const int corner : f) append(bytes, std::int32_t{corner});
  }
  return bytes;
}

std::string textStl() {
  const Corners corners = boxCorners();
  std::string text = "solid box\n";
  for (const auto& t : boxTriangles()) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int c : t) text += fmt::format("vertex {} {} {}\n", corners[c][0], corners[c][1], corners[c][2]);
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid box\n";
}

std::string binaryStl(std::string title = "box") {
  const Corners corners = boxCorners();
  title.resize(80, ' ');
  append(title, std::uint32_t{12});
  for (const auto& t : boxTriangles()) {
    for (int i = 0; i < 3; ++i) append(title, 0.0F);
    for (const int c : t) {
      for (const double x : corners[c]) append(title, static_cast<float>(x));
    }
    append(title, std::uint16_t{0});
  }
  return title;
}

/// The box as a glTF buffer: a cube of edge 1 with y up; its node makes it long, wide and high.
std::string gltfBuffer(double number = 0.5) {
  std::string bytes;
  for (int i = 0; i < 8; ++i) {
    for (int k = 0; k < 3; ++k) append(bytes, static_cast<float>((i >> k & 1) ? number : -0.5));
  }
  for (const auto& t : boxTriangles()) {
    for (const int c : t) append(bytes, static_cast<std::uint16_t>(c));
  }
  return bytes;
}

/// glTF: +z forward, +x left, +y up. The child stretches, the parent shifts; both must act.
nlohmann::json gltf(std::size_t buffer_bytes) {
  return nlohmann::json::parse(fmt::format(R"({{
    "asset": {{"version": "2.0"}}, "scene": 0, "scenes": [{{"nodes": [0]}}],
    "nodes": [{{"children": [1], "translation": [0.25, 0.5, 0.75]}},
              {{"mesh": 0, "scale": [{}, {}, {}]}}],
    "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}, "indices": 1, "mode": 4}}]}}],
    "accessors": [{{"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3",
                   "min": [-0.5, -0.5, -0.5], "max": [0.5, 0.5, 0.5]}},
                  {{"bufferView": 1, "componentType": 5123, "count": 36, "type": "SCALAR"}}],
    "bufferViews": [{{"buffer": 0, "byteOffset": 0, "byteLength": 96}},
                    {{"buffer": 0, "byteOffset": 96, "byteLength": 72}}],
    "buffers": [{{"byteLength": {}}}]}})",
                                           kSize[1], kSize[2], kSize[0], buffer_bytes));
}
const Vector3 kGltfShift{0.75, 0.25, 0.5};  // forward, left, up

std::string glb(const std::string& buffer) {
  std::string text = gltf(buffer.size()).dump(), bytes = "glTF";
  text.resize((text.size() + 3) / 4 * 4, ' ');
  append(bytes, std::uint32_t{2});
  append(bytes, static_cast<std::uint32_t>(12 + 8 + text.size() + 8 + buffer.size()));
  append(bytes, static_cast<std::uint32_t>(text.size()));
  bytes += "JSON" + text;
  append(bytes, static_cast<std::uint32_t>(buffer.size()));
  return bytes + std::string("BIN\0", 4) + buffer;
}

std::string refusal(const std::filesystem::path& file) {
  return lab::refusal([&] { (void)readMesh({.file = file, .scale = 1.0}); });
}

/// Ranges to one object along a fan of rays; 0 where nothing is met.
std::vector<double> ranges(const Shape& shape, const Pose& pose) {
  Scene scene;
  scene.materials.push_back({.name = "m"});
  scene.objects.push_back({.id = "o", .shape = shape, .pose = pose});
  const RayTracer tracer(scene);
  std::vector<Ray> rays;
  for (int i = -30; i <= 30; ++i) {
    for (int k = -30; k <= 30; ++k) {
      const double azimuth = 0.0061 * i, elevation = 0.0061 * k, ce = std::cos(elevation);
      rays.push_back({{}, {ce * std::cos(azimuth), ce * std::sin(azimuth), std::sin(elevation)}});
    }
  }
  std::vector<RayHit> hits(rays.size());
  tracer.trace(rays, hits);
  std::vector<double> found;
  for (const RayHit& hit : hits) found.push_back(hit.object < 0 ? 0.0 : hit.range_m);
  return found;
}

void expectSameAsBox(const std::filesystem::path& file, const Vector3& shift) {
  const Pose pose{{12.0, 0.5, 0.3}, 33.0, -12.0, 21.0};
  const Pose back{pose.toWorld({-shift[0], -shift[1], -shift[2]}), pose.yaw_deg, pose.pitch_deg, pose.roll_deg};
  const auto box = ranges(Box{kSize}, pose), mesh = ranges(Mesh{file, 1.0}, back);
  int met = 0, edges = 0;
  for (std::size_t i = 0; i < box.size(); ++i) {
    if ((box[i] > 0.0) != (mesh[i] > 0.0)) {
      ++edges;
      continue;
    }
    if (box[i] > 0.0) ++met;
    EXPECT_NEAR(mesh[i], box[i], 2e-5) << file;  // single precision at 12 m: 1e-6 m a coordinate, slanted faces
  }
  EXPECT_GT(met, 500) << file;
  EXPECT_LE(edges, 2) << file;
}

// The box primitive is the oracle: it needs no file.
TEST(Mesh, BoxInEveryFormatGivesTheRangesOfTheBoxPrimitive) {
  const test_support::TemporaryFolder folder;
  expectSameAsBox(folder.write("box.obj", objOf(boxCorners(), kSides)), {});
  expectSameAsBox(folder.write("text.ply", textPly()), {});
  expectSameAsBox(folder.write("binary.ply", binaryPly()), {});
  expectSameAsBox(folder.write("text.stl", textStl()), {});
  expectSameAsBox(folder.write("binary.stl", binaryStl()), {});
  expectSameAsBox(folder.write("solid.STL", binaryStl("solid, although binary")), {});
}

TEST(Mesh, GltfIsTurnedFromYUpAndItsNodesActOneAfterTheOther) {
  const test_support::TemporaryFolder folder;
  expectSameAsBox(folder.write("box.glb", glb(gltfBuffer())), kGltfShift);
  nlohmann::json beside = gltf(gltfBuffer().size());
  beside["buffers"][0]["uri"] = "box.bin";
  (void)folder.write("box.bin", gltfBuffer());
  const auto file = folder.write("box.gltf", beside.dump());
  expectSameAsBox(file, kGltfShift);
  EXPECT_EQ(filesOfMesh(file), (std::vector<std::filesystem::path>{file, folder / "box.bin"}));
  EXPECT_EQ(filesOfMesh(folder / "box.glb").size(), 1U);
}

TEST(Mesh, ScaleMultipliesEveryLength) {
  const test_support::TemporaryFolder folder;
  const Triangles read = readMesh({.file = folder.write("box.obj", objOf(boxCorners(), kSides)), .scale = 0.001});
  ASSERT_EQ(read.faces.size(), 12U);
  for (const Vector3& v : read.vertices) {
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(std::abs(v[k]), kSize[k] / 2000.0, 1e-9);
  }
}

TEST(Mesh, LibraryReadsAFileOnceForEachScale) {
  const test_support::TemporaryFolder folder;
  const auto file = folder.write("box.obj", objOf(boxCorners(), kSides));
  (void)folder.write("sub/other.obj", objOf(boxCorners(), {{0, 1, 2}}));
  MeshLibrary library;
  const Triangles& first = library.of({.file = file, .scale = 1.0});
  std::filesystem::remove(file);  // whoever reads again, fails
  EXPECT_EQ(&library.of({.file = folder / "sub/../box.obj", .scale = 1.0}), &first);
  EXPECT_EQ(library.of({.file = folder / "sub/other.obj", .scale = 1.0}).faces.size(), 1U);
  EXPECT_EQ(library.size(), 2U);
  EXPECT_NE(lab::refusal([&] { (void)library.of({.file = file, .scale = 2.0}); }), "");
}

TEST(Mesh, FacesWithoutAreaAreLeftOut) {
  const test_support::TemporaryFolder folder;
  Faces faces = kSides;
  faces.push_back({0, 0, 1});
  EXPECT_EQ(readMesh({.file = folder.write("some.obj", objOf(boxCorners(), faces)), .scale = 1.0}).faces.size(), 12U);
  EXPECT_NE(refusal(folder.write("all.obj", objOf({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}})))
                .find("only faces without area"),
            std::string::npos);
}

TEST(Mesh, MissingAndUnknownFilesAreNamed) {
  const test_support::TemporaryFolder folder;
  EXPECT_NE(refusal(folder / "no.obj").find("no.obj: the mesh file does not exist"), std::string::npos);
  EXPECT_NE(refusal(folder.path()).find("does not exist"), std::string::npos);
  EXPECT_NE(refusal(folder.write("car.fbx", "x")).find("Use OBJ, PLY, STL, glTF or GLB."), std::string::npos);
}

TEST(Mesh, NotFiniteCoordinatesAreRefused) {
  const test_support::TemporaryFolder folder;
  const std::string ply = plyHeader("binary_little_endian");
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    std::string bytes = binaryPly();
    std::memcpy(bytes.data() + ply.size() + 12, &bad, sizeof bad);
    EXPECT_NE(refusal(folder.write("bad.ply", bytes)).find("not finite"), std::string::npos);
    EXPECT_NE(refusal(folder.write("bad.glb", glb(gltfBuffer(bad)))).find("not finite"), std::string::npos);
  }
  EXPECT_NE(refusal(folder.write("bad.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")).find("the mesh"),
            std::string::npos);
}

TEST(Mesh, FacesThatNameNoVertexAreRefused) {
  const test_support::TemporaryFolder folder;
  EXPECT_NE(refusal(folder.write("far.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n")).find("the mesh"),
            std::string::npos);
  std::string bytes = binaryPly();
  const std::int32_t far = 4711;
  std::memcpy(bytes.data() + plyHeader("binary_little_endian").size() + 96 + 1, &far, sizeof far);
  EXPECT_NE(refusal(folder.write("far.ply", bytes)).find("the mesh"), std::string::npos);
  std::string buffer = gltfBuffer();
  const std::uint16_t short_far = 4711;
  std::memcpy(buffer.data() + 96, &short_far, sizeof short_far);
  const std::string message = "the mesh has a face that names vertex 4711, of 8.";
  EXPECT_NE(refusal(folder.write("far.glb", glb(buffer))).find(message), std::string::npos);
  nlohmann::json beside = gltf(buffer.size());
  beside["buffers"][0]["uri"] = "far.bin";
  (void)folder.write("far.bin", buffer);
  EXPECT_NE(refusal(folder.write("beside.gltf", beside.dump())).find(message), std::string::npos);
  // Three indices 0, 1, 4711 as bytes 00 00 01 00 67 12, in base64 by hand; no vertices: only their number is asked.
  const auto inside = nlohmann::json::parse(R"({"asset": {"version": "2.0"},
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
    "accessors": [{"componentType": 5126, "count": 8, "type": "VEC3"},
                  {"bufferView": 0, "componentType": 5123, "count": 3, "type": "SCALAR"}],
    "bufferViews": [{"buffer": 0, "byteLength": 6}],
    "buffers": [{"byteLength": 6, "uri": "data:application/octet-stream;base64,AAABAGcS"}]})");
  EXPECT_NE(refusal(folder.write("inside.gltf", inside.dump())).find(message), std::string::npos);
}

TEST(Mesh, PointsAloneAreNoMesh) {
  const test_support::TemporaryFolder folder;
  EXPECT_NE(refusal(folder.write("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n")).find("the mesh"), std::string::npos);
  EXPECT_NE(refusal(folder.write("points.ply",
                                 "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty "
                                 "float y\nproperty float z\nend_header\n0 0 0\n"))
                .find("the mesh"),
            std::string::npos);
}

// Cut anywhere, a file must be refused or be whole in what it still says; it must never crash or hang.
TEST(Mesh, CutFilesAreRefused) {
  const test_support::TemporaryFolder folder;
  const std::pair<const char*, std::string> whole[] = {{"cut.ply", binaryPly()},
                                                       {"cut_text.ply", textPly()},
                                                       {"cut.stl", binaryStl()},
                                                       {"cut_text.stl", textStl()},
                                                       {"cut.glb", glb(gltfBuffer())}};
  for (const auto& [name, content] : whole) {
    for (const double part : {0.0, 0.02, 0.2, 0.5, 0.8, 0.95}) {
      const auto length = static_cast<std::size_t>(part * static_cast<double>(content.size()));
      EXPECT_NE(refusal(folder.write(name, content.substr(0, length))).find("the mesh"), std::string::npos)
          << name << " " << part;
    }
  }
  EXPECT_NE(refusal(folder.write("cut.gltf", gltf(168).dump().substr(0, 200))).find("the mesh"), std::string::npos);
  nlohmann::json lost = gltf(168);
  lost["buffers"][0]["uri"] = "gone.bin";
  EXPECT_NE(refusal(folder.write("lost.gltf", lost.dump())).find("the mesh"), std::string::npos);
  EXPECT_NE(refusal(folder.write("noise.obj", "\x01\x02\xff\xfe garbage f v 1 2")).find("the mesh"), std::string::npos);
}

// A sparse file of 3 GB takes no room on the disk; nothing of it may be read before the refusal.
TEST(Mesh, TooBigAFileIsRefusedWithTheMemoryThatItWouldTake) {
  const test_support::TemporaryFolder folder;
  const auto file = folder.write("big.obj", "v 0 0 0\n");
  std::filesystem::resize_file(file, 3'000'000'000);
  const std::string message = refusal(file);
  EXPECT_NE(message.find("too big: its file has 3.00 GB"), std::string::npos) << message;
  EXPECT_NE(message.find("GB of memory"), std::string::npos);
}

TEST(Mesh, FewTrianglesRepeatedTooOftenAreRefusedBeforeMemoryRunsOut) {
  EXPECT_NE(lab::refusal([] { checkTriangleCount("many.glb", 1'200'000'000); }).find("too big"), std::string::npos);
  EXPECT_EQ(lab::refusal([] { checkTriangleCount("street.ply", 5'000'000); }), "");
}

}  // namespace
}  // namespace model
