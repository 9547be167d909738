#include "core/npy.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <regex>
#include <string>

#include "core/error.h"
#include "core/file.h"

namespace core {

namespace {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they lie in the file");

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& problem) {
  throw InputError({.file = file}, problem, "Save it with numpy.save(file, one_dimensional_array).");
}

template <typename Number>
std::vector<double> numbersIn(const std::string& bytes) {
  std::vector<double> numbers(bytes.size() / sizeof(Number));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    Number number;
    std::memcpy(&number, bytes.data() + i * sizeof(Number), sizeof(Number));
    numbers[i] = static_cast<double>(number);
  }
  return numbers;
}

/// The header: a Python dictionary as text. Returns it and where the numbers begin.
std::pair<std::string, std::size_t> headerOf(const std::string& content, const std::filesystem::path& file) {
  if (content.size() < 10 || content.compare(0, 6, "\x93NUMPY") != 0) refuse(file, "is no .npy file.");
  const auto byte = [&](std::size_t i) { return static_cast<std::size_t>(static_cast<unsigned char>(content[i])); };
  const bool short_length = byte(6) == 1;
  const std::size_t begin = short_length ? 10 : 12;
  if (content.size() < begin) refuse(file, "ends within its header.");
  std::size_t length = byte(8) + (byte(9) << 8);
  if (!short_length) length += (byte(10) << 16) + (byte(11) << 24);
  if (content.size() - begin < length) refuse(file, "ends within its header.");
  return {content.substr(begin, length), begin + length};
}

std::string found(const std::string& header, const char* pattern, const std::filesystem::path& file) {
  std::smatch match;
  if (!std::regex_search(header, match, std::regex(pattern))) refuse(file, "has a header that cannot be read.");
  return match[1];
}

std::vector<double> numbersOf(const std::string& type, const std::string& bytes, const std::filesystem::path& file) {
  if (type == "<f8") return numbersIn<double>(bytes);
  if (type == "<f4") return numbersIn<float>(bytes);
  if (type == "<i8") return numbersIn<std::int64_t>(bytes);
  if (type == "<u8") return numbersIn<std::uint64_t>(bytes);
  if (type == "<i4") return numbersIn<std::int32_t>(bytes);
  if (type == "<u4") return numbersIn<std::uint32_t>(bytes);
  if (type == "<i2") return numbersIn<std::int16_t>(bytes);
  if (type == "<u2") return numbersIn<std::uint16_t>(bytes);
  if (type == "|u1") return numbersIn<std::uint8_t>(bytes);
  refuse(file, "holds numbers of type '" + type + "', which is not known.");
}

}  // namespace

std::vector<double> readNpy(const std::filesystem::path& file) {
  const std::string content = readFile(file);
  const auto [header, begin] = headerOf(content, file);
  const std::string type = found(header, "'descr'\\s*:\\s*'([^']*)'", file);
  const std::string shape = found(header, "'shape'\\s*:\\s*\\(\\s*([0-9]*)\\s*,?\\s*\\)", file);
  const std::vector<double> numbers = numbersOf(type, content.substr(begin), file);
  if (shape.empty() || shape.size() > 15 || std::stoull(shape) != numbers.size()) {
    refuse(file, "does not hold as many numbers as its header says.");
  }
  for (const double number : numbers) {
    if (!std::isfinite(number)) refuse(file, "holds a number that is not finite.");
  }
  return numbers;
}

}  // namespace core
