#include <fmt/core.h>
#include <fmt/format.h>
#include <iterator>

#include "bench/street.h"
#include "core/file.h"

namespace bench {

namespace {

std::string obj(const model::Triangles& triangles) {
  std::string text = "# metres; x forward, y left, z up\n";
  for (const auto& v : triangles.vertices)
    fmt::format_to(std::back_inserter(text), "v {:.9g} {:.9g} {:.9g}\n", v[0], v[1], v[2]);
  for (const auto& f : triangles.faces)
    fmt::format_to(std::back_inserter(text), "f {} {} {}\n", f[0] + 1, f[1] + 1, f[2] + 1);
  return text;
}

template <typename Number>
void append(std::string& bytes, Number number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof(number));
}

std::string ply(const model::Triangles& triangles) {
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment metres; x forward, y left, z up\n"
      "element vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
      "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      triangles.vertices.size(), triangles.faces.size());
  for (const auto& v : triangles.vertices) {
    for (const double number : v) append(bytes, static_cast<float>(number));
  }
  for (const auto& f : triangles.faces) {
    append(bytes, std::uint8_t{3});
    for (const std::uint32_t index : f) append(bytes, static_cast<std::int32_t>(index));
  }
  return bytes;
}

}  // namespace

void writeMesh(const model::Triangles& triangles, const std::filesystem::path& file) {
  core::writeFile(file, file.extension() == ".obj" ? obj(triangles) : ply(triangles));
}

}  // namespace bench
