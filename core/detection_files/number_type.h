#pragma once

#include <bit>
#include <cstddef>
#include <string>

namespace core {

/// How a binary file keeps a number.
enum class NumberType { kI8, kU8, kI16, kU16, kI32, kU32, kI64, kU64, kF32, kF64 };

[[nodiscard]] std::size_t sizeOf(NumberType type);
[[nodiscard]] bool isReal(NumberType type);

/// The number that begins at `bytes`, of which sizeOf(type) must be readable.
[[nodiscard]] double loadNumber(const char* bytes, NumberType type, std::endian order = std::endian::little);

/// Appends `value`; whole types take its rounded value.
void appendNumber(std::string& bytes, double value, NumberType type, std::endian order = std::endian::little);

}  // namespace core
