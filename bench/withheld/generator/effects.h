#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/withheld/generator/fields.h"

namespace withheld {

/// A parameter of an effect: a number with its bounds, three coordinates, a list of numbers, or a law of reflection.
struct Parameter {
  enum class Kind { number, place, list, law };
  std::string name;
  double low, high;
  Kind kind = Kind::number;
};

/// The list to read to see what this world can do. Names and parameters are those of the effect library; names that
/// begin with "x-" are effects that the library does not have.
struct EffectEntry {
  std::string name;
  std::vector<Parameter> parameters;
};

[[nodiscard]] const std::vector<EffectEntry>& allEffects();

/// The effects that truly exist in one world.
class Effects {
 public:
  /// Throws BadInput at unknown effects and parameters, and at numbers out of bounds.
  Effects(const Json& json, const std::string& place);

  /// Those of one sensor: an effect with "sensors": ["a", …] exists on these only.
  [[nodiscard]] Effects of(const std::string& sensor) const;

  [[nodiscard]] bool on(const std::string& effect) const { return given_.contains(effect); }
  /// The number given, or nothing; also nothing if the effect is off.
  [[nodiscard]] std::optional<double> number(const std::string& effect, const std::string& parameter) const;
  [[nodiscard]] double number(const std::string& effect, const std::string& parameter, double otherwise) const {
    return number(effect, parameter).value_or(otherwise);
  }
  /// A list, empty if not given.
  [[nodiscard]] std::vector<double> list(const std::string& effect, const std::string& parameter) const;
  [[nodiscard]] std::string text(const std::string& effect, const std::string& parameter) const;

 private:
  std::map<std::string, Json> given_;
};

}  // namespace withheld
