#include "model/scene/gltf_file.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "core/error.h"
#include "core/file.h"

namespace model {

namespace {

using nlohmann::json;

/// The JSON of a glTF and, of a GLB, the binary chunk behind it (glTF 2.0 specification, section 4 "GLB").
struct Gltf {
  json description;
  std::string chunk;
};

std::uint32_t wordAt(const std::string& bytes, std::size_t at) {
  std::uint32_t word = 0;
  if (at + sizeof word <= bytes.size()) std::memcpy(&word, bytes.data() + at, sizeof word);
  return word;
}

Gltf parse(const std::filesystem::path& file) {
  const std::string content = core::readFile(file);
  if (content.rfind("glTF", 0) != 0) return {json::parse(content, nullptr, false), ""};
  constexpr std::size_t kText = 20;  // 12 bytes of header, 8 of the first chunk
  const std::size_t length = wordAt(content, 12);
  if (content.size() < kText || length > content.size() - kText) return {};
  Gltf gltf{json::parse(content.substr(kText, length), nullptr, false), ""};
  if (content.size() > kText + length + 8) gltf.chunk = content.substr(kText + length + 8);
  return gltf;
}

std::string fromBase64(std::string_view text) {
  static constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char digit : text) {
    const std::size_t value = kDigits.find(digit);
    if (value == std::string_view::npos) break;  // padding
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    count += 6;
    if (count >= 8) bytes += static_cast<char>(bits >> (count -= 8) & 0xFF);
  }
  return bytes;
}

/// nullopt if the buffer is not to be had here; its reader then says so.
std::optional<std::string> bufferOf(const Gltf& gltf, const std::filesystem::path& file, const json& buffer) {
  const std::string uri = buffer.value("uri", "");
  if (uri.empty()) return gltf.chunk;
  if (uri.rfind("data:", 0) == 0) return fromBase64(std::string_view(uri).substr(uri.find(',') + 1));
  const auto beside = file.parent_path() / uri;
  return std::filesystem::is_regular_file(beside) ? std::optional(core::readFile(beside)) : std::nullopt;
}

std::uint32_t largestIndex(const std::string& bytes, std::size_t at, std::size_t count, int component) {
  const std::size_t width = component == 5121 ? 1 : component == 5123 ? 2 : 4;
  std::uint32_t largest = 0;
  for (std::size_t i = 0; i < count && width <= bytes.size() && at <= bytes.size() - width; ++i, at += width) {
    std::uint32_t index = 0;
    std::memcpy(&index, bytes.data() + at, width);  // little-endian, as the file
    largest = std::max(largest, index);
  }
  return largest;
}

/// Buffers by number, each read once.
using Buffers = std::map<std::size_t, std::optional<std::string>>;

void checkPrimitive(const Gltf& gltf, const std::filesystem::path& file, const json& primitive, Buffers& buffers) {
  if (!primitive.contains("indices")) return;
  const json& all = gltf.description;
  const json& accessor = all.at("accessors").at(primitive.at("indices").get<std::size_t>());
  if (!accessor.contains("bufferView")) return;
  const json& view = all.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
  const auto number = view.at("buffer").get<std::size_t>();
  if (!buffers.count(number)) buffers[number] = bufferOf(gltf, file, all.at("buffers").at(number));
  const std::optional<std::string>& bytes = buffers[number];
  if (!bytes) return;
  const std::size_t at = view.value("byteOffset", std::size_t{0}) + accessor.value("byteOffset", std::size_t{0});
  const auto largest =
      largestIndex(*bytes, at, accessor.at("count").get<std::size_t>(), accessor.at("componentType").get<int>());
  const auto position = primitive.at("attributes").at("POSITION").get<std::size_t>();
  const auto vertices = all.at("accessors").at(position).at("count").get<std::size_t>();
  if (largest >= vertices) {
    throw core::InputError({.file = file},
                           fmt::format("the mesh has a face that names vertex {}, of {}.", largest, vertices),
                           "Vertices are counted from 0; the file is damaged, export it again.");
  }
}

}  // namespace

void checkGltfIndices(const std::filesystem::path& file) {
  const Gltf gltf = parse(file);
  if (!gltf.description.is_object()) return;  // its reader says what is wrong
  Buffers buffers;
  try {
    for (const json& mesh : gltf.description.value("meshes", json::array())) {
      for (const json& primitive : mesh.at("primitives")) checkPrimitive(gltf, file, primitive, buffers);
    }
  } catch (const json::exception&) {  // likewise
  }
}

std::vector<std::filesystem::path> buffersOfGltf(const std::filesystem::path& file) {
  std::vector<std::filesystem::path> files;
  const Gltf gltf = parse(file);
  if (!gltf.description.is_object()) return files;
  try {
    for (const json& buffer : gltf.description.value("buffers", json::array())) {
      const std::string uri = buffer.value("uri", "");
      if (!uri.empty() && uri.rfind("data:", 0) != 0) files.push_back(file.parent_path() / uri);
    }
  } catch (const json::exception&) {  // its reader says what is wrong
  }
  return files;
}

}  // namespace model
