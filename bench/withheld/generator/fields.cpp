#include "bench/withheld/generator/fields.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>
#include <numeric>

#include "bench/withheld/generator/bad_input.h"

namespace withheld {

namespace {

// Levenshtein distance, one row at a time.
std::size_t editsBetween(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

double finite(const Json& value, const std::string& place) {
  if (!value.is_number() || !std::isfinite(value.get<double>())) {
    throw BadInput(place, fmt::format("{} is not a number.", value.dump()), "Give a finite number.");
  }
  return value.get<double>();
}

}  // namespace

Json readJson(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw BadInput(file, "cannot be read.", "Check the path.");
  try {
    return Json::parse(stream);
  } catch (const Json::parse_error& error) {
    throw BadInput(file, fmt::format("is no JSON ({}).", error.what()), "Repair it at the byte named.");
  }
}

std::string nearestOf(const std::string& wrong, const std::vector<std::string>& known) {
  return *std::min_element(known.begin(), known.end(), [&](const std::string& a, const std::string& b) {
    return editsBetween(wrong, a) < editsBetween(wrong, b);
  });
}

Fields::Fields(const Json& value, std::string place, const std::vector<std::string>& known)
    : value_(value), place_(std::move(place)) {
  if (!value.is_object()) throw BadInput(place_, "is not an object.", "Write {\"key\": value, …}.");
  for (const auto& [key, unused] : value.items()) {
    if (key.starts_with("x-") || std::find(known.begin(), known.end(), key) != known.end()) continue;
    throw BadInput(placeOf(key), "is not a key that is known here.",
                   known.empty() ? "Nothing may stand here."
                                 : fmt::format("The nearest known key is '{}'.", nearestOf(key, known)));
  }
}

const Json* Fields::find(const std::string& key) const {
  const auto found = value_.find(key);
  return found == value_.end() || found->is_null() ? nullptr : &*found;
}

const Json& Fields::at(const std::string& key) const {
  const Json* value = find(key);
  if (!value) throw BadInput(placeOf(key), "is missing.", "Add it.");
  return *value;
}

double Fields::number(const std::string& key) const { return finite(at(key), placeOf(key)); }

double Fields::number(const std::string& key, double otherwise) const { return maybe(key).value_or(otherwise); }

std::optional<double> Fields::maybe(const std::string& key) const {
  const Json* value = find(key);
  return value ? std::optional(finite(*value, placeOf(key))) : std::nullopt;
}

std::vector<double> Fields::numbers(const std::string& key, std::size_t count) const {
  const Json& list = at(key);
  if (!list.is_array() || (count != 0 && list.size() != count)) {
    throw BadInput(placeOf(key), "is not a list of the right length.",
                   count ? fmt::format("Give {} numbers in brackets.", count) : "Give numbers in brackets.");
  }
  std::vector<double> values;
  for (const Json& value : list) values.push_back(finite(value, placeOf(key)));
  return values;
}

std::string Fields::text(const std::string& key) const {
  const Json& value = at(key);
  if (!value.is_string()) throw BadInput(placeOf(key), "is not a text.", "Write it in quotes.");
  return value.get<std::string>();
}

std::string Fields::oneOf(const std::string& key, const std::vector<std::string>& allowed,
                          const std::string& otherwise) const {
  if (!find(key)) return otherwise;
  const std::string value = text(key);
  if (std::find(allowed.begin(), allowed.end(), value) == allowed.end()) {
    throw BadInput(placeOf(key), fmt::format("'{}' is none of {}.", value, fmt::join(allowed, ", ")),
                   fmt::format("The nearest is '{}'.", nearestOf(value, allowed)));
  }
  return value;
}

}  // namespace withheld
