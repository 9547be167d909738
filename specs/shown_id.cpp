#include "specs/shown_id.h"

#include <algorithm>

namespace specs {

namespace {

bool isUpper(char c) { return c >= 'A' && c <= 'Z'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isLower(char c) { return c >= 'a' && c <= 'z'; }
bool isAlphanumeric(char c) { return isUpper(c) || isLower(c) || isDigit(c); }

bool isNamePart(std::string_view part) {
  return !part.empty() && isUpper(part[0]) && std::all_of(part.begin(), part.end(), isAlphanumeric);
}

bool isNumberPart(std::string_view part) {
  return !part.empty() && part.size() <= 9 && part[0] != '0' && std::all_of(part.begin(), part.end(), isDigit);
}

/// Letters beyond ASCII that German authors and Greek symbols bring; all others separate words.
std::string spelledOut(std::string_view title) {
  static constexpr std::pair<std::string_view, std::string_view> kLetters[] = {
      {"ä", "ae"}, {"ö", "oe"}, {"ü", "ue"}, {"Ä", "Ae"},    {"Ö", "Oe"},   {"Ü", "Ue"},
      {"ß", "ss"}, {"é", "e"},  {"è", "e"},  {"α", "alpha"}, {"β", "beta"}, {"λ", "lambda"}};
  std::string text(title);
  for (const auto& [letter, ascii] : kLetters) {
    for (auto at = text.find(letter); at != std::string::npos; at = text.find(letter)) {
      text.replace(at, letter.size(), ascii);
    }
  }
  return text;
}

}  // namespace

bool isShownId(std::string_view id) {
  const auto last = id.rfind('_');
  if (last == std::string_view::npos || !isNumberPart(id.substr(last + 1))) return false;
  std::string_view names = id.substr(0, last);
  for (auto bar = names.find('_'); bar != std::string_view::npos; bar = names.find('_')) {
    if (!isNamePart(names.substr(0, bar))) return false;
    names.remove_prefix(bar + 1);
  }
  // At least phenomenon and cause: one bar must stand before the number's.
  return isNamePart(names) && id.substr(0, last).find('_') != std::string_view::npos;
}

std::string camelCase(std::string_view title, std::size_t max_words) {
  std::string result;
  std::size_t words = 0;
  bool begins_word = true;
  for (const char c : spelledOut(title)) {
    if (!isAlphanumeric(c)) {
      begins_word = true;
      continue;
    }
    if (begins_word && ++words > max_words) break;
    result += begins_word && isLower(c) ? static_cast<char>(c - 'a' + 'A') : c;
    begins_word = false;
  }
  if (!result.empty() && isDigit(result[0])) result.insert(0, "N");  // a part begins with a letter
  return result;
}

std::string proposeId(std::string_view phenomenon, std::string_view causes, std::span<const std::string> taken) {
  const auto part = [](std::string_view title, std::string_view otherwise) {
    const std::string name = camelCase(title);
    return name.empty() ? std::string(otherwise) : name;
  };
  const std::string stem = part(phenomenon, "Phenomenon") + "_" + part(causes, "Cause") + "_";
  for (int number = 1;; ++number) {
    std::string id = stem + std::to_string(number);
    if (std::find(taken.begin(), taken.end(), id) == taken.end()) return id;
  }
}

std::string proposeId(const cepra::Row& row, std::span<const std::string> taken) {
  return proposeId(row.phenomenon().title, row.lastEffect().title, taken);
}

bool naturallyLess(std::string_view a, std::string_view b) {
  std::size_t i = 0;
  std::size_t j = 0;
  const auto number = [](std::string_view text, std::size_t& at) {
    while (at + 1 < text.size() && text[at] == '0' && isDigit(text[at + 1])) ++at;
    const std::size_t begin = at;
    while (at < text.size() && isDigit(text[at])) ++at;
    return text.substr(begin, at - begin);
  };
  while (i < a.size() && j < b.size()) {
    if (isDigit(a[i]) && isDigit(b[j])) {
      const std::string_view left = number(a, i);
      const std::string_view right = number(b, j);
      if (left.size() != right.size()) return left.size() < right.size();
      if (left != right) return left < right;
    } else {
      if (a[i] != b[j]) return a[i] < b[j];
      ++i;
      ++j;
    }
  }
  if (a.size() - i != b.size() - j) return a.size() - i < b.size() - j;
  return a < b;  // "01" and "1": a total order all the same
}

}  // namespace specs
