#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace core {

/// Reads the text at the beginning of a point cloud line by line and remembers where it is. LF or CRLF.
class HeaderLines {
 public:
  HeaderLines(std::filesystem::path file, std::string_view content) : file_(std::move(file)), content_(content) {}

  /// The words of the next line; nullopt at the end of the file.
  [[nodiscard]] std::optional<std::vector<std::string>> next();

  [[nodiscard]] std::size_t offset() const noexcept { return offset_; }  ///< of the byte after the last line read
  [[nodiscard]] int line() const noexcept { return line_; }              ///< 1-based, of the last line read
  [[nodiscard]] Place place() const { return {.file = file_, .line = line_, .item = ""}; }

 private:
  std::filesystem::path file_;
  std::string_view content_;
  std::size_t offset_ = 0;
  int line_ = 0;
};

/// A whole number from 0 to `most`; throws InputError at `place` that names `what`.
[[nodiscard]] std::size_t countOf(const Place& place, const std::string& what, const std::string& word,
                                  double most = 1e12);

/// A finite or infinite number or NaN; throws InputError at `place` that names `what`.
[[nodiscard]] double numberOf(const Place& place, const std::string& what, const std::string& word);

}  // namespace core
