#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace core {

/// The whole file; decompressed if its content is gzip. Throws InputError if it cannot be read.
[[nodiscard]] std::string readFile(const std::filesystem::path& file);

/// Writes all or nothing: a temporary file beside it, flushed to disk, then renamed over it. Compressed if the name
/// ends in ".gz" (without time stamp, so the same content gives the same bytes). Throws InputError if it cannot be
/// written (no folder, no permission, disk full); the old file is then untouched. A symbolic link stays one: the file
/// that it names is written. Devices and pipes are written to, never replaced.
void writeFile(const std::filesystem::path& file, std::string_view content);

/// SHA-256 as 64 hexadecimal digits.
[[nodiscard]] std::string sha256(std::string_view content);
[[nodiscard]] std::string sha256OfFile(const std::filesystem::path& file);

/// The folder with sensor profiles, rating scales and the demo project: $FIDELIS_RESOURCES, else the one beside the
/// installed program, else the one of the source tree.
[[nodiscard]] std::filesystem::path resourceFolder();

}  // namespace core
