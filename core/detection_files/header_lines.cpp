#include "core/detection_files/header_lines.h"

#include <cmath>

#include "core/text.h"

namespace core {

std::optional<std::vector<std::string>> HeaderLines::next() {
  if (offset_ >= content_.size()) return std::nullopt;
  const std::size_t end = std::min(content_.find('\n', offset_), content_.size());
  std::string_view text = content_.substr(offset_, end - offset_);
  offset_ = std::min(end + 1, content_.size());
  ++line_;
  std::vector<std::string> words;
  constexpr std::string_view kSpace = " \t\r";
  while (true) {
    const std::size_t begin = text.find_first_not_of(kSpace);
    if (begin == std::string_view::npos) return words;
    const std::size_t stop = std::min(text.find_first_of(kSpace, begin), text.size());
    words.emplace_back(text.substr(begin, stop - begin));
    text.remove_prefix(stop);
  }
}

std::size_t countOf(const Place& place, const std::string& what, const std::string& word, double most) {
  double value = 0.0;
  if (!parseNumber(word, value) || !(value >= 0.0) || value > most || value != std::floor(value)) {
    throw InputError(place, "'" + word + "' is not a number for " + what + ".", "Export the file again.");
  }
  return static_cast<std::size_t>(value);
}

double numberOf(const Place& place, const std::string& what, const std::string& word) {
  double value = 0.0;
  if (!parseNumber(word, value)) {
    throw InputError(place, what + ": '" + word + "' is not a number.", "Correct the line or export the file again.");
  }
  return value;
}

}  // namespace core
