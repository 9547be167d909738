#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace acceptance {

enum class Order { LessOrEqual, Less, GreaterOrEqual, Greater };
[[nodiscard]] std::string_view symbol(Order order);  ///< "<=", "<", ">=", ">"

/// One comparison of an expression with the numbers of a sample put in: `value` is the left side, `limit` the right.
struct Relation {
  std::string left;   ///< as written: "abs(d_bias)"
  std::string right;  ///< "0.005 * range_m"
  Order order = Order::LessOrEqual;
  double value = 0.0;
  double limit = 0.0;
  bool holds = false;  ///< false if a side is not a number

  /// How far inside the limit the value lies; < 0: outside. [unit of the sides]
  [[nodiscard]] double margin() const noexcept;
  /// "abs(d_bias) = 0.0123 <= 0.0499", or with "is not <=" if it does not hold.
  [[nodiscard]] std::string text() const;
};

/// What an expression says about one sample.
struct Decision {
  bool holds = false;
  std::vector<Relation> relations;
  /// The relation that decides: the one with the smallest margin relative to its limit. Never empty after evaluate().
  [[nodiscard]] const Relation& decisive() const;
};

/// An acceptance expression: relations `left <= right` (or <, >=, >), joined by `&&`, all of which must hold.
///
///   abs(d_bias) <= 0.005 * range_m  &&  d_cavm <= 0.010 * range_m
///
/// The sides are arithmetic with the functions of muParser (abs, min, max, sqrt, exp, log, …). A side may not hold a
/// relation itself: every limit shall be readable in the report.
class Expression {
 public:
  /// Throws InputError at `place` with the position in the text and what stands there: no relation, two relations
  /// without `&&`, `==`, `||`, a lone `=`, unbalanced parentheses, bad arithmetic, an unknown function.
  Expression(std::string text, core::Place place);

  [[nodiscard]] const std::string& text() const noexcept { return text_; }
  /// Names that the sides use, sorted.
  [[nodiscard]] std::vector<std::string> variables() const;
  /// Throws InputError with position and nearest name for a variable that is not among `known`.
  void requireKnown(std::span<const std::string> known) const;
  /// Every variable must be among `values` (see requireKnown).
  [[nodiscard]] Decision evaluate(const std::map<std::string, double>& values) const;

 private:
  struct Side {
    std::string text;
    std::size_t at;  ///< where it begins in text_
    std::vector<std::string> variables;
  };
  struct Comparison {
    Side left;
    Order order;
    Side right;
  };

  Comparison comparisonOf(std::size_t begin, std::size_t end) const;
  Side sideOf(std::size_t begin, std::size_t end) const;
  double number(const Side& side, const std::map<std::string, double>& values) const;
  void requireKnown(const Side& side, std::span<const std::string> known) const;
  [[noreturn]] void fail(std::size_t at, const std::string& problem, const std::string& remedy) const;

  std::string text_;
  core::Place place_;
  std::vector<Comparison> comparisons_;
};

}  // namespace acceptance
