#include "app/desktop/any_item.h"

#include <algorithm>

#include "specs/fields.h"
#include "specs/shown_id.h"

namespace desktop {

namespace {

template <class T>
std::vector<T>& listOf(specs::Specification& specification) {
  if constexpr (std::is_same_v<T, specs::Requirement>) return specification.requirements;
  if constexpr (std::is_same_v<T, specs::AcceptanceTest>) return specification.tests;
  if constexpr (std::is_same_v<T, specs::ExperimentData>) return specification.experiment_data;
  if constexpr (std::is_same_v<T, specs::ReferenceData>) return specification.reference_data;
}

template <class T>
void eraseFrom(std::vector<T>& items, const std::string& uid) {
  std::erase_if(items, [&](const T& item) { return item.uid == uid; });
}

}  // namespace

const specs::Item& base(const AnyItem& item) {
  return std::visit([](const auto& it) -> const specs::Item& { return it; }, item);
}

specs::Kind kindOf(const AnyItem& item) {
  return std::visit([](const auto& it) { return specs::kindOf<std::decay_t<decltype(it)>>(); }, item);
}

AnyItem emptyItem(specs::Kind kind) {
  switch (kind) {
    case specs::Kind::AcceptanceTest:
      return specs::AcceptanceTest{};
    case specs::Kind::ExperimentData:
      return specs::ExperimentData{};
    case specs::Kind::ReferenceData:
      return specs::ReferenceData{};
    default:
      return specs::Requirement{};
  }
}

std::vector<ItemField> fieldsOf(const AnyItem& item) {
  return std::visit(
      [](const auto& it) {
        std::vector<ItemField> fields;
        for (const auto& field : specs::fieldsOf<std::decay_t<decltype(it)>>()) {
          if (field.name == "uid") continue;
          fields.push_back({std::string(field.name), std::string(field.title), field.get(it)});
        }
        return fields;
      },
      item);
}

std::string setField(AnyItem& item, const std::string& name, const std::string& text) {
  return std::visit(
      [&](auto& it) -> std::string {
        for (const auto& field : specs::fieldsOf<std::decay_t<decltype(it)>>()) {
          if (field.name == name) return field.set(it, text);
        }
        return "there is no field '" + name + "'";
      },
      item);
}

std::vector<AnyItem> itemsOf(const specs::Specification& specification) {
  std::vector<AnyItem> items;
  items.insert(items.end(), specification.requirements.begin(), specification.requirements.end());
  items.insert(items.end(), specification.tests.begin(), specification.tests.end());
  items.insert(items.end(), specification.experiment_data.begin(), specification.experiment_data.end());
  items.insert(items.end(), specification.reference_data.begin(), specification.reference_data.end());
  return items;
}

void eraseItem(specs::Specification& specification, const std::string& uid) {
  eraseFrom(specification.requirements, uid);
  eraseFrom(specification.tests, uid);
  eraseFrom(specification.experiment_data, uid);
  eraseFrom(specification.reference_data, uid);
}

void insertItem(specs::Specification& specification, const AnyItem& item) {
  std::visit(
      [&](const auto& it) {
        using T = std::decay_t<decltype(it)>;
        std::vector<T>& items = listOf<T>(specification);
        const auto at = std::upper_bound(items.begin(), items.end(), it,
                                         [](const T& a, const T& b) { return specs::naturallyLess(a.id, b.id); });
        items.insert(at, it);
      },
      item);
}

}  // namespace desktop
