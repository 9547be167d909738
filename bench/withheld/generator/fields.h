#pragma once

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace withheld {

using Json = nlohmann::json;

/// Reads the file. Throws BadInput if it is missing or no JSON.
[[nodiscard]] Json readJson(const std::string& file);

/// The known name that is fewest edits away from `wrong`.
[[nodiscard]] std::string nearestOf(const std::string& wrong, const std::vector<std::string>& known);

/// One JSON object whose keys are asked for by name. `place` is "file: /pointer" and stands in every error.
/// Refers to the object: keep it alive.
class Fields {
 public:
  /// Throws BadInput if `value` is no object or holds a key that is neither known nor begins with "x-".
  Fields(const Json& value, std::string place, const std::vector<std::string>& known);

  [[nodiscard]] const Json* find(const std::string& key) const;  ///< null pointer if absent or null
  [[nodiscard]] const Json& at(const std::string& key) const;
  [[nodiscard]] double number(const std::string& key) const;
  [[nodiscard]] double number(const std::string& key, double otherwise) const;
  [[nodiscard]] std::optional<double> maybe(const std::string& key) const;
  [[nodiscard]] std::vector<double> numbers(const std::string& key, std::size_t count = 0) const;
  [[nodiscard]] std::string text(const std::string& key) const;
  [[nodiscard]] std::string oneOf(const std::string& key, const std::vector<std::string>& allowed,
                                  const std::string& otherwise) const;
  [[nodiscard]] std::string placeOf(const std::string& key) const { return place_ + "/" + key; }
  [[nodiscard]] const std::string& place() const { return place_; }

 private:
  const Json& value_;
  std::string place_;
};

}  // namespace withheld
