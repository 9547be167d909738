#include "model/scene/mesh_file.h"

#include <algorithm>
#include <cstring>
#include <fmt/format.h>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/text.h"

namespace model {

namespace {

/// Upper bounds of what reading took at its peak (ru_maxrss) for the benchmarks' street of 207 000 triangles as OBJ,
/// PLY, binary STL and GLB: 0.8 kB to 0.95 kB a triangle, 16 to 31 bytes for a byte of the file.
constexpr double kMemoryPerTriangle_bytes = 950.0;
constexpr double kMemoryPerFileByte = 32.0;

core::InputError cutOff(const std::filesystem::path& file, const std::string& why) {
  return {{.file = file}, "the mesh is cut off: " + why + ".", "Copy or export it again."};
}

std::string start(const std::filesystem::path& file, std::size_t bytes) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    throw core::InputError({.file = file}, "the mesh file cannot be read.", "Check that you may read it.");
  }
  std::string content(bytes, '\0');
  stream.read(content.data(), static_cast<std::streamsize>(bytes));
  content.resize(static_cast<std::size_t>(stream.gcount()));
  return content;
}

std::uint32_t littleEndian(const std::string& content, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, content.data() + at, sizeof value);
  return value;
}

double sizeOfPlyType(const std::string& type) {
  static const std::map<std::string, double> sizes{{"char", 1},  {"uchar", 1},   {"int8", 1},   {"uint8", 1},
                                                   {"short", 2}, {"ushort", 2},  {"int16", 2},  {"uint16", 2},
                                                   {"int", 4},   {"uint", 4},    {"int32", 4},  {"uint32", 4},
                                                   {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
  const auto known = sizes.find(type);
  return known == sizes.end() ? 1.0 : known->second;
}

/// What a PLY's header promises to follow it.
struct PlyPromise {
  bool text = false;
  double lines = 0.0;  ///< of a text file: one for each element
  double bytes = 0.0;  ///< of a binary file, at least
  bool ends_with_list = false;
};

PlyPromise promisedByPly(std::istringstream header) {
  PlyPromise promise;
  double count = 0.0;
  for (std::string line; std::getline(header, line);) {
    std::istringstream words(line);
    std::string word, type, name;
    words >> word >> type;
    if (word == "format") promise.text = type == "ascii";
    if (word == "element" && (words >> count)) promise.lines += count;
    if (word != "property") continue;
    std::string of_index;
    const bool list = type == "list";
    if (list) words >> type >> of_index;
    words >> name;
    const double indices = name.rfind("vertex_ind", 0) == 0 ? 3.0 : 0.0;
    promise.bytes += count * (sizeOfPlyType(type) + indices * sizeOfPlyType(of_index));
    promise.ends_with_list = list && count > 0.0;
  }
  return promise;
}

/// Lines of a text PLY after its header, and whether the last one has as many numbers as its list announces.
void checkPlyLines(const std::filesystem::path& file, const PlyPromise& promise, std::size_t header) {
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(header));
  double lines = 0.0;
  std::string last;
  for (std::string line; std::getline(stream, line);) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    ++lines;
    last = std::move(line);
  }
  if (lines < promise.lines) {
    throw cutOff(file, fmt::format("its header promises {:.0f} lines, {:.0f} follow", promise.lines, lines));
  }
  std::istringstream words(last);
  double announced = 0.0, number = 0.0;
  if (!promise.ends_with_list || lines > promise.lines || !(words >> announced)) return;
  for (; announced > 0.0; --announced) {
    if (!(words >> number)) throw cutOff(file, "its last line is not complete");
  }
}

void checkPly(const std::filesystem::path& file, double size) {
  const std::string content = start(file, 1 << 16);
  if (content.rfind("ply", 0) != 0) return;  // assimp says what it is not
  const std::size_t end = content.find("end_header");
  if (end == std::string::npos) throw cutOff(file, "its PLY header has no 'end_header'");  // assimp would never return
  const PlyPromise promise = promisedByPly(std::istringstream(content.substr(0, end)));
  const std::size_t header = end + 10;
  if (promise.text) {
    checkPlyLines(file, promise, header);
  } else if (promise.bytes > size - static_cast<double>(header)) {
    throw cutOff(file, fmt::format("its header promises at least {:.0f} bytes, {:.0f} follow", promise.bytes,
                                   size - static_cast<double>(header)));
  }
}

void checkStl(const std::filesystem::path& file, double size) {
  const std::string content = start(file, 84);
  if (content.size() < 84 && content.rfind("solid", 0) != 0) throw cutOff(file, "an STL has a header of 84 bytes");
  const double promised = content.size() < 84 ? 0.0 : 84.0 + 50.0 * littleEndian(content, 80);
  if (content.rfind("solid", 0) != 0) {
    if (promised > size)
      throw cutOff(file, fmt::format("its header promises {:.0f} bytes, it has {:.0f}", promised, size));
    return;
  }
  if (promised == size) return;  // binary with a header that begins like text
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(-static_cast<std::streamoff>(std::min(size, 256.0)), std::ios::end);
  const std::string last{std::istreambuf_iterator<char>(stream), {}};
  if (core::lowerCase(last).find("endsolid") == std::string::npos)
    throw cutOff(file, "it has no 'endsolid' at its end");
}

void checkGlb(const std::filesystem::path& file, double size) {
  const std::string content = start(file, 12);
  if (content.size() < 12) throw cutOff(file, "a GLB has a header of 12 bytes");
  const double promised = littleEndian(content, 8);
  if (promised > size)
    throw cutOff(file, fmt::format("its header promises {:.0f} bytes, it has {:.0f}", promised, size));
}

core::InputError tooBig(const std::filesystem::path& file, const std::string& what, double bytes) {
  return {{.file = file},
          fmt::format("the mesh is too big: {}; reading it would take about {:.1f} GB of memory, at most {:.0f} GB are "
                      "spent on one.",
                      what, bytes / 1e9, kMostMemory_bytes / 1e9),
          "Reduce its number of triangles, or split it into several objects."};
}

}  // namespace

void checkMeshFile(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file)) {
    throw core::InputError({.file = file}, "the mesh file does not exist.",
                           "Check the name; it is relative to experiment.json.");
  }
  const std::string ending = core::lowerCase(file.extension().string());
  static const std::vector<std::string> known{".obj", ".ply", ".stl", ".gltf", ".glb"};
  if (std::find(known.begin(), known.end(), ending) == known.end()) {
    throw core::InputError({.file = file}, "the mesh is of no known format: its name ends in '" + ending + "'.",
                           "Use OBJ, PLY, STL, glTF or GLB.");
  }
  const auto size = static_cast<double>(std::filesystem::file_size(file));
  if (size == 0.0) throw cutOff(file, "it is empty");
  if (ending == ".ply") checkPly(file, size);
  if (ending == ".stl") checkStl(file, size);
  if (ending == ".glb") checkGlb(file, size);
  if (size * kMemoryPerFileByte > kMostMemory_bytes) {
    throw tooBig(file, fmt::format("its file has {:.2f} GB", size / 1e9), size * kMemoryPerFileByte);
  }
}

void checkTriangleCount(const std::filesystem::path& file, std::uint64_t triangles) {
  const double bytes = static_cast<double>(triangles) * kMemoryPerTriangle_bytes;
  if (bytes > kMostMemory_bytes) throw tooBig(file, fmt::format("it has {} triangles or more", triangles), bytes);
}

}  // namespace model
