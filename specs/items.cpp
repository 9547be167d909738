#include "specs/items.h"

#include <array>
#include <cassert>

namespace specs {

namespace {

constexpr std::array<std::string_view, 5> kKinds = {"CEPRA row", "requirement", "acceptance test",
                                                    "experiment data requirement", "reference data requirement"};
constexpr std::array<std::string_view, 3> kStatuses = {"under review", "accepted", "rejected"};
constexpr std::array<std::string_view, 3> kLevels = {"general", "object-model", "detection-model"};

template <class Enum, std::size_t n>
std::optional<Enum> find(const std::array<std::string_view, n>& names, std::string_view name) {
  for (std::size_t i = 0; i < n; ++i) {
    if (names[i] == name) return static_cast<Enum>(i);
  }
  return std::nullopt;
}

}  // namespace

bool mayLink(Kind from, Kind to) {
  switch (from) {
    case Kind::CepraRow:
      return to == Kind::Requirement;
    case Kind::Requirement:
      return to == Kind::Requirement || to == Kind::AcceptanceTest;
    case Kind::AcceptanceTest:
      return to == Kind::ExperimentData || to == Kind::ReferenceData;
    case Kind::ExperimentData:
      return to == Kind::ReferenceData;
    case Kind::ReferenceData:
      return false;
  }
  return false;
}

std::string_view name(Kind kind) { return kKinds[static_cast<std::size_t>(kind)]; }
std::string_view name(Status status) { return kStatuses[static_cast<std::size_t>(status)]; }
std::string_view name(Level level) { return kLevels[static_cast<std::size_t>(level)]; }
Kind kindNamed(std::string_view name) {
  const auto kind = find<Kind>(kKinds, name);
  assert(kind);
  return kind.value_or(Kind::Requirement);
}

std::optional<Status> statusOf(std::string_view name) { return find<Status>(kStatuses, name); }
std::optional<Level> levelOf(std::string_view name) { return find<Level>(kLevels, name); }

}  // namespace specs
