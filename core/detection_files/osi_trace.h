#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace core {

/// An ASAM OSI 3 trace (.osi): little-endian uint32 length, then one serialised message, repeated.
/// One file holds messages of one kind; the bytes do not name it, but the numbers of their fields tell.
enum class OsiKind {
  kUnknown,
  kSensorView,  ///< what a sensor model is fed with
  kSensorData,  ///< what a sensor, or its model, reports
};

struct OsiTrace {
  std::filesystem::path file;
  OsiKind kind = OsiKind::kUnknown;
  std::vector<std::string_view> messages;  ///< into the content that was read

  /// "message 3 (byte 812)": counted from 1, the byte at which its length stands.
  [[nodiscard]] Place placeOf(std::size_t message) const;
};

/// Splits a trace. Throws InputError with message number and byte if it is cut off, a length is impossible, a message
/// is no protocol buffer, or messages of two kinds are mixed.
[[nodiscard]] OsiTrace readOsiTrace(const std::filesystem::path& file, std::string_view content);

/// Whether the content begins with a message of a known kind.
[[nodiscard]] bool beginsWithOsiMessage(std::string_view content);

/// Throws InputError at the message unless `has` is true and the major version is 3 (the standard requires the field).
void checkOsiVersion(const OsiTrace& trace, std::size_t message, bool has, unsigned major);

/// Appends length and message.
void appendOsiMessage(std::string& trace, const std::string& message);

/// For a trace in which no message has what was looked for; `without_version` is the first that lacks its version, too.
[[nodiscard]] InputError noLidarIn(const OsiTrace& trace, std::optional<std::size_t> without_version = std::nullopt);

/// The release of the standard whose fields we write.
inline constexpr unsigned kOsiMajor = 3;
inline constexpr unsigned kOsiMinor = 7;

}  // namespace core
