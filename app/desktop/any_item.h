#pragma once

#include <string>
#include <variant>
#include <vector>

#include "specs/items.h"
#include "specs/project_store.h"

namespace desktop {

/// One item of a specification, whatever its kind: what forms, trees and undo commands handle alike.
using AnyItem = std::variant<specs::Requirement, specs::AcceptanceTest, specs::ExperimentData, specs::ReferenceData>;

[[nodiscard]] const specs::Item& base(const AnyItem& item);
[[nodiscard]] specs::Kind kindOf(const AnyItem& item);
/// An empty item of a kind that is not CepraRow.
[[nodiscard]] AnyItem emptyItem(specs::Kind kind);

/// One line of a form (specs/fields.h).
struct ItemField {
  std::string name;
  std::string title;
  std::string value;
};
/// All fields but the internal id.
[[nodiscard]] std::vector<ItemField> fieldsOf(const AnyItem& item);
/// Returns what is wrong with the text, or "" if it was taken.
[[nodiscard]] std::string setField(AnyItem& item, const std::string& name, const std::string& text);

/// All items of a specification, requirements first.
[[nodiscard]] std::vector<AnyItem> itemsOf(const specs::Specification& specification);
void eraseItem(specs::Specification& specification, const std::string& uid);
/// Keeps the natural order of the shown ids.
void insertItem(specs::Specification& specification, const AnyItem& item);

}  // namespace desktop
