#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace core {

/// Reads and parses a JSON file (gzip allowed). Doubled keys, syntax errors and a file that cannot be read throw
/// InputError with line and column.
[[nodiscard]] nlohmann::json readJson(const std::filesystem::path& file);

/// Two-space indentation and a final newline; keys in alphabetical order unless the value is an ordered_json.
void writeJson(const std::filesystem::path& file, const nlohmann::json& value);
void writeJson(const std::filesystem::path& file, const nlohmann::ordered_json& value);

/// What a number must satisfy. The default admits every finite number.
struct Bounds {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool open_min = false;  ///< true: must be greater than min
};

/// One JSON object that is read key by key. Whoever reads it ends with finish(), which refuses every key that nobody
/// asked for (except those that begin with "x-"), with the file, the JSON Pointer and the nearest known key.
/// Keeps a reference: the JSON value must outlive it.
class JsonObject {
 public:
  /// Throws InputError if `value` is not an object.
  JsonObject(const nlohmann::json& value, std::filesystem::path file, std::string pointer = "");

  [[nodiscard]] bool has(const std::string& key);  ///< present and not null
  [[nodiscard]] double number(const std::string& key, Bounds bounds = {});
  [[nodiscard]] double numberOr(const std::string& key, double otherwise, Bounds bounds = {});
  [[nodiscard]] std::optional<double> optionalNumber(const std::string& key, Bounds bounds = {});  ///< null: nullopt
  [[nodiscard]] long long integer(const std::string& key, Bounds bounds = {});
  [[nodiscard]] long long integerOr(const std::string& key, long long otherwise, Bounds bounds = {});
  [[nodiscard]] bool flagOr(const std::string& key, bool otherwise);
  [[nodiscard]] std::string text(const std::string& key);
  [[nodiscard]] std::string textOr(const std::string& key, std::string otherwise);
  /// One of `choices`; the error names them all and the nearest.
  [[nodiscard]] std::string choice(const std::string& key, const std::vector<std::string>& choices);
  [[nodiscard]] std::string choiceOr(const std::string& key, const std::vector<std::string>& choices,
                                     const std::string& otherwise);
  /// Exactly `count` numbers (any number of them if `count` is 0).
  [[nodiscard]] std::vector<double> numbers(const std::string& key, std::size_t count = 0);
  [[nodiscard]] std::vector<std::string> texts(const std::string& key);  ///< absent: empty
  [[nodiscard]] JsonObject object(const std::string& key);
  /// Calls `read` for every element of an array of objects (absent: none).
  void eachObject(const std::string& key, const std::function<void(JsonObject&)>& read);
  /// The raw value, for keys whose content is free.
  [[nodiscard]] const nlohmann::json& raw(const std::string& key);
  [[nodiscard]] std::vector<std::string> keys() const;

  /// Checks `"format"` and `"version"`; a newer version is refused with the words to say so.
  void expectFormat(const std::string& format, int version);

  /// Refuses keys that were never asked for.
  void finish() const;

  [[nodiscard]] const std::string& pointer() const noexcept { return pointer_; }
  [[nodiscard]] const std::filesystem::path& file() const noexcept { return file_; }
  [[nodiscard]] const nlohmann::json& value() const noexcept { return *value_; }
  [[noreturn]] void fail(const std::string& key, const std::string& problem, const std::string& remedy) const;

 private:
  const nlohmann::json& need(const std::string& key);
  const nlohmann::json* find(const std::string& key);
  double checked(const std::string& key, const nlohmann::json& value, Bounds bounds) const;

  const nlohmann::json* value_;
  std::filesystem::path file_;
  std::string pointer_;
  std::set<std::string> known_;
};

}  // namespace core
