#include "core/json_object.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "core/error.h"
#include "core/file.h"
#include "core/text.h"

namespace core {

using nlohmann::json;

namespace {

/// Refuses doubled keys, which nlohmann::json otherwise resolves silently.
json parseWithoutDoubledKeys(const std::filesystem::path& file, const std::string& text) {
  std::vector<std::set<std::string>> keys;
  const auto callback = [&](int, json::parse_event_t event, json& parsed) {
    if (event == json::parse_event_t::object_start) keys.emplace_back();
    if (event == json::parse_event_t::object_end) keys.pop_back();
    if (event == json::parse_event_t::key && !keys.back().insert(parsed.get<std::string>()).second) {
      throw InputError({.file = file},
                       fmt::format("the key '{}' stands twice in one object.", parsed.get<std::string>()),
                       "Remove one of the two.");
    }
    return true;
  };
  return json::parse(text, callback);
}

std::string kindOf(const json& value) { return value.type_name(); }

template <typename Json>
void writeIndented(const std::filesystem::path& file, const Json& value) {
  writeFile(file, value.dump(2) + "\n");
}

}  // namespace

json readJson(const std::filesystem::path& file) {
  const std::string text = readFile(file);
  try {
    return parseWithoutDoubledKeys(file, text);
  } catch (const json::parse_error& error) {
    std::string what = error.what();
    if (const auto colon = what.find("syntax error"); colon != std::string::npos) what = what.substr(colon);
    throw InputError({.file = file, .line = lineAt(text, error.byte > 0 ? error.byte - 1 : 0)},
                     "not valid JSON: " + what + ".", "Mend the text there; a JSON-aware editor marks the spot.");
  } catch (const json::out_of_range& error) {  // 1e999
    const std::string what = error.what();
    throw InputError({.file = file}, "not valid JSON: " + what.substr(what.find("] ") + 2) + ".",
                     "Write a number that a double can hold.");
  }
}

void writeJson(const std::filesystem::path& file, const json& value) { writeIndented(file, value); }
void writeJson(const std::filesystem::path& file, const nlohmann::ordered_json& value) { writeIndented(file, value); }

JsonObject::JsonObject(const json& value, std::filesystem::path file, std::string pointer)
    : value_(&value), file_(std::move(file)), pointer_(std::move(pointer)) {
  if (!value.is_object()) {
    throw InputError({.file = file_, .item = pointer_.empty() ? "(root)" : pointer_},
                     "is a " + kindOf(value) + "; an object was expected.", "Write { … } there.");
  }
}

void JsonObject::fail(const std::string& key, const std::string& problem, const std::string& remedy) const {
  throw InputError({.file = file_, .item = pointer_ + "/" + key}, problem, remedy);
}

const json* JsonObject::find(const std::string& key) {
  known_.insert(key);
  const auto found = value_->find(key);
  return found == value_->end() || found->is_null() ? nullptr : &*found;
}

const json& JsonObject::need(const std::string& key) {
  if (const json* value = find(key)) return *value;
  fail(key, "is missing.", "Add the key.");
}

bool JsonObject::has(const std::string& key) { return find(key) != nullptr; }

double JsonObject::checked(const std::string& key, const json& value, Bounds bounds) const {
  if (!value.is_number()) fail(key, "is a " + kindOf(value) + "; a number was expected.", "Write a number.");
  const double number = value.get<double>();
  const bool too_small = bounds.open_min ? number <= bounds.min : number < bounds.min;
  if (too_small || number > bounds.max || !std::isfinite(number)) {
    fail(key,
         fmt::format("is {}; it must be {} {} and at most {}.", number, bounds.open_min ? "greater than" : "at least",
                     bounds.min, bounds.max),
         "Give a value in that range.");
  }
  return number;
}

double JsonObject::number(const std::string& key, Bounds bounds) { return checked(key, need(key), bounds); }

double JsonObject::numberOr(const std::string& key, double otherwise, Bounds bounds) {
  const json* value = find(key);
  return value ? checked(key, *value, bounds) : otherwise;
}

std::optional<double> JsonObject::optionalNumber(const std::string& key, Bounds bounds) {
  const json* value = find(key);
  return value ? std::optional(checked(key, *value, bounds)) : std::nullopt;
}

long long JsonObject::integer(const std::string& key, Bounds bounds) {
  const double value = number(key, bounds);
  if (value != std::floor(value)) fail(key, fmt::format("is {}; a whole number was expected.", value), "Round it.");
  return static_cast<long long>(value);
}

long long JsonObject::integerOr(const std::string& key, long long otherwise, Bounds bounds) {
  return has(key) ? integer(key, bounds) : otherwise;
}

bool JsonObject::flagOr(const std::string& key, bool otherwise) {
  const json* value = find(key);
  if (!value) return otherwise;
  if (!value->is_boolean())
    fail(key, "is a " + kindOf(*value) + "; true or false was expected.", "Write true or false.");
  return value->get<bool>();
}

std::string JsonObject::text(const std::string& key) {
  const json& value = need(key);
  if (!value.is_string()) fail(key, "is a " + kindOf(value) + "; a text was expected.", "Put it in quotes.");
  return value.get<std::string>();
}

std::string JsonObject::textOr(const std::string& key, std::string otherwise) {
  return has(key) ? text(key) : std::move(otherwise);
}

std::string JsonObject::choice(const std::string& key, const std::vector<std::string>& choices) {
  const std::string given = text(key);
  if (std::find(choices.begin(), choices.end(), given) != choices.end()) return given;
  const std::string nearest = nearestName(given, choices);
  fail(key, "'" + given + "' is not known; known are " + join(choices) + ".",
       nearest.empty() ? "Choose one of them." : "Did you mean '" + nearest + "'?");
}

std::string JsonObject::choiceOr(const std::string& key, const std::vector<std::string>& choices,
                                 const std::string& otherwise) {
  return has(key) ? choice(key, choices) : otherwise;
}

std::vector<double> JsonObject::numbers(const std::string& key, std::size_t count) {
  const json& value = need(key);
  if (!value.is_array()) fail(key, "is a " + kindOf(value) + "; a list of numbers was expected.", "Write [ … ].");
  if (count > 0 && value.size() != count) {
    fail(key, fmt::format("has {} elements; {} were expected.", value.size(), count), "Give one number each.");
  }
  std::vector<double> list;
  for (std::size_t i = 0; i < value.size(); ++i) list.push_back(checked(key + "/" + std::to_string(i), value[i], {}));
  return list;
}

std::vector<std::string> JsonObject::texts(const std::string& key) {
  const json* value = find(key);
  if (!value) return {};
  if (!value->is_array()) fail(key, "is a " + kindOf(*value) + "; a list of texts was expected.", "Write [ … ].");
  std::vector<std::string> list;
  for (std::size_t i = 0; i < value->size(); ++i) {
    if (!(*value)[i].is_string()) fail(key + "/" + std::to_string(i), "is not a text.", "Put it in quotes.");
    list.push_back((*value)[i].get<std::string>());
  }
  return list;
}

JsonObject JsonObject::object(const std::string& key) { return {need(key), file_, pointer_ + "/" + key}; }

void JsonObject::eachObject(const std::string& key, const std::function<void(JsonObject&)>& read) {
  const json* list = find(key);
  if (!list) return;
  if (!list->is_array()) fail(key, "is a " + kindOf(*list) + "; a list was expected.", "Write [ … ].");
  for (std::size_t i = 0; i < list->size(); ++i) {
    JsonObject element((*list)[i], file_, pointer_ + "/" + key + "/" + std::to_string(i));
    read(element);
    element.finish();
  }
}

const json& JsonObject::raw(const std::string& key) { return need(key); }

std::vector<std::string> JsonObject::keys() const {
  std::vector<std::string> names;
  for (const auto& item : value_->items()) names.push_back(item.key());
  return names;
}

void JsonObject::expectFormat(const std::string& format, int version) {
  if (const std::string given = text("format"); given != format) {
    fail("format", "is '" + given + "'; '" + format + "' was expected.", "Check that this is the right file.");
  }
  if (const long long given = integer("version"); given != version) {
    fail("version", fmt::format("is {}; this program reads version {}.", given, version),
         given > version ? "Use a newer Fidelis." : "Convert the file to the current version.");
  }
}

void JsonObject::finish() const {
  for (const auto& item : value_->items()) {
    if (known_.count(item.key()) > 0 || item.key().rfind("x-", 0) == 0) continue;
    const std::vector<std::string> known(known_.begin(), known_.end());
    const std::string nearest = nearestName(item.key(), known);
    fail(item.key(), "is an unknown key.",
         (nearest.empty() ? "Known here: " + join(known) + "." : "Did you mean '" + nearest + "'?") +
             " Keys of your own begin with 'x-'.");
  }
}

}  // namespace core
