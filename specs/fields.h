#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "specs/items.h"

namespace specs {

/// One field of an item as text: what the tables of the database, the lists in CSV, the documents and the history have
/// in common. The text form loses nothing.
template <class T>
struct Field {
  std::string_view name;   ///< column in CSV and database: "experiment"
  std::string_view title;  ///< for people: "Experiment"
  std::string (*get)(const T& item);
  /// Returns what is wrong with the text, or "" if it was taken.
  std::string (*set)(T& item, const std::string& text);
};

/// First the fields of Item in the order of their declaration, then those of the kind.
/// T is Requirement, AcceptanceTest, ExperimentData or ReferenceData.
template <class T>
[[nodiscard]] std::span<const Field<T>> fieldsOf();

/// How many of the first fields are those of Item.
inline constexpr std::size_t kCommonFields = 7;

/// "a; b": parts with ';' or '\' inside get a backslash before them. Empty parts are kept.
[[nodiscard]] std::string joinList(std::span<const std::string> parts);
[[nodiscard]] std::vector<std::string> splitList(std::string_view text);

}  // namespace specs
