#include "core/detection_files/osi_trace.h"

#include <fmt/format.h>
#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/wire_format_lite.h>
#include <limits>
#include <optional>
#include <set>

#include "core/detection_files/number_type.h"

namespace core {

namespace {

constexpr std::size_t kLengthBytes = 4;
constexpr const char* kCopyAgain = "Copy or record the trace again.";

/// The numbers of a message's fields; nullopt if it is no protocol buffer.
std::optional<std::set<int>> fieldNumbers(std::string_view message) {
  using google::protobuf::internal::WireFormatLite;
  google::protobuf::io::CodedInputStream stream(reinterpret_cast<const std::uint8_t*>(message.data()),
                                                static_cast<int>(message.size()));
  std::set<int> numbers;
  while (static_cast<std::size_t>(stream.CurrentPosition()) < message.size()) {
    const std::uint32_t tag = stream.ReadTag();
    const int number = WireFormatLite::GetTagFieldNumber(tag);
    if (tag == 0 || number == 0 || !WireFormatLite::SkipField(&stream, tag)) return std::nullopt;
    numbers.insert(number);
  }
  return numbers;
}

/// SensorView has fields 1 to 8 and from 1000 on, SensorData 1 to 29. With 1 to 8 alone it is a view: data without
/// anything detected carry at least the header of what was looked for.
OsiKind kindOf(const std::set<int>& numbers) {
  constexpr int kLastOfView = 8, kLastOfData = 29, kFirstOfSensorViews = 1000, kLastOfSensorViews = 1004;
  OsiKind kind = OsiKind::kSensorView;
  for (const int number : numbers) {
    if (number > kLastOfView && number <= kLastOfData) kind = OsiKind::kSensorData;
    if (number > kLastOfData && (number < kFirstOfSensorViews || number > kLastOfSensorViews)) return OsiKind::kUnknown;
  }
  return numbers.empty() ? OsiKind::kUnknown : kind;
}

const char* nameOf(OsiKind kind) {
  switch (kind) {
    case OsiKind::kSensorView:
      return "SensorView";
    case OsiKind::kSensorData:
      return "SensorData";
    case OsiKind::kUnknown:
      break;
  }
  return "unknown";
}

std::size_t lengthAt(std::string_view content, std::size_t offset) {
  return static_cast<std::size_t>(loadNumber(content.data() + offset, NumberType::kU32));
}

/// The next message; throws if it is not whole.
std::string_view messageAt(const std::filesystem::path& file, std::string_view content, std::size_t offset,
                           std::size_t number) {
  const Place place{.file = file, .item = fmt::format("message {} (byte {})", number, offset)};
  if (content.size() - offset < kLengthBytes) {
    throw InputError(place, fmt::format("is cut off: {} bytes are left, a length has 4.", content.size() - offset),
                     kCopyAgain);
  }
  const std::size_t length = lengthAt(content, offset);
  const std::size_t left = content.size() - offset - kLengthBytes;
  if (length == 0) throw InputError(place, "is empty (length 0).", kCopyAgain);
  if (length > left) {
    throw InputError(
        place,
        fmt::format("announces {} bytes, but {} follow: the trace is cut off, or the length is wrong.", length, left),
        kCopyAgain);
  }
  return content.substr(offset + kLengthBytes, length);
}

}  // namespace

Place OsiTrace::placeOf(std::size_t message) const {
  const std::size_t byte = static_cast<std::size_t>(messages[message].data() - messages.front().data());
  return {.file = file, .line = 0, .item = fmt::format("message {} (byte {})", message + 1, byte)};
}

OsiTrace readOsiTrace(const std::filesystem::path& file, std::string_view content) {
  OsiTrace trace{.file = file, .kind = OsiKind::kUnknown, .messages = {}};
  if (content.empty()) throw InputError({.file = file}, "is empty: the trace has no message.", kCopyAgain);
  for (std::size_t offset = 0; offset < content.size();) {
    const std::size_t number = trace.messages.size() + 1;
    const std::string_view message = messageAt(file, content, offset, number);
    trace.messages.push_back(message);
    const auto numbers = message.size() <= std::numeric_limits<int>::max() ? fieldNumbers(message) : std::nullopt;
    const OsiKind kind = numbers ? kindOf(*numbers) : OsiKind::kUnknown;
    if (kind == OsiKind::kUnknown) {
      throw InputError(trace.placeOf(number - 1), "is no SensorView and no SensorData of ASAM OSI 3.",
                       "Check that the file is a trace with 4 bytes of length before every message.");
    }
    if (number > 1 && kind != trace.kind) {
      throw InputError(trace.placeOf(number - 1),
                       fmt::format("is {}, the messages before are {}.", nameOf(kind), nameOf(trace.kind)),
                       "Keep one kind of message in a trace.");
    }
    trace.kind = kind;
    offset += kLengthBytes + message.size();
  }
  return trace;
}

bool beginsWithOsiMessage(std::string_view content) {
  if (content.size() <= kLengthBytes) return false;
  const std::size_t length = lengthAt(content, 0);
  if (length == 0 || length > content.size() - kLengthBytes || length > std::numeric_limits<int>::max()) return false;
  const auto numbers = fieldNumbers(content.substr(kLengthBytes, length));
  return numbers && kindOf(*numbers) != OsiKind::kUnknown;
}

void checkOsiVersion(const OsiTrace& trace, std::size_t message, bool has, unsigned major) {
  if (!has) {
    throw InputError(trace.placeOf(message), "has no interface version, which the standard requires.",
                     "Set the field version to the release with which the trace was written.");
  }
  if (major != kOsiMajor) {
    throw InputError(trace.placeOf(message), fmt::format("has the interface version {}; {} is read.", major, kOsiMajor),
                     "Write the trace with a release 3.x of ASAM OSI.");
  }
}

void appendOsiMessage(std::string& trace, const std::string& message) {
  appendNumber(trace, static_cast<double>(message.size()), NumberType::kU32);
  trace += message;
}

InputError noLidarIn(const OsiTrace& trace, std::optional<std::size_t> without_version) {
  const std::string also =
      without_version ? fmt::format(" Message {} has no interface version either.", *without_version + 1) : "";
  const bool view = trace.kind == OsiKind::kSensorView;
  return {{.file = trace.file},
          fmt::format("has no lidar inside: none of its {} {} messages has {}.{}", trace.messages.size(),
                      nameOf(trace.kind), view ? "a lidar_sensor_view" : "a feature_data.lidar_sensor", also),
          view ? "Record what the lidar reports (SensorData), or the view of a lidar's environment model."
               : "Record the lidar's detections (feature_data)."};
}

}  // namespace core
