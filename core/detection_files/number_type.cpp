#include "core/detection_files/number_type.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace core {

namespace {

/// Calls `use` with a value of the C++ type that stands for `type`.
template <typename Use>
auto asType(NumberType type, Use use) {
  switch (type) {
    case NumberType::kI8:
      return use(std::int8_t{});
    case NumberType::kU8:
      return use(std::uint8_t{});
    case NumberType::kI16:
      return use(std::int16_t{});
    case NumberType::kU16:
      return use(std::uint16_t{});
    case NumberType::kI32:
      return use(std::int32_t{});
    case NumberType::kU32:
      return use(std::uint32_t{});
    case NumberType::kI64:
      return use(std::int64_t{});
    case NumberType::kU64:
      return use(std::uint64_t{});
    case NumberType::kF32:
      return use(float{});
    case NumberType::kF64:
      break;
  }
  return use(double{});
}

}  // namespace

std::size_t sizeOf(NumberType type) {
  return asType(type, [](auto value) { return sizeof value; });
}

bool isReal(NumberType type) { return type == NumberType::kF32 || type == NumberType::kF64; }

double loadNumber(const char* bytes, NumberType type, std::endian order) {
  return asType(type, [&](auto value) {
    std::array<char, sizeof value> raw{};
    std::copy_n(bytes, sizeof value, raw.begin());
    if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
    std::memcpy(&value, raw.data(), sizeof value);
    return static_cast<double>(value);
  });
}

void appendNumber(std::string& bytes, double value, NumberType type, std::endian order) {
  asType(type, [&](auto kind) {
    using Number = decltype(kind);
    if constexpr (std::is_floating_point_v<Number>) {
      kind = static_cast<Number>(value);
    } else {
      kind = static_cast<Number>(std::llround(value));
    }
    std::array<char, sizeof kind> raw{};
    std::memcpy(raw.data(), &kind, sizeof kind);
    if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
    bytes.append(raw.data(), raw.size());
    return 0;
  });
}

}  // namespace core
