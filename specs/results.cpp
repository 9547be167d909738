#include "specs/results.h"

#include <array>

namespace specs {

namespace {
constexpr std::array<std::string_view, 4> kVerdicts = {"passed", "failed", "error", "skipped"};
}

std::string_view name(Verdict verdict) { return kVerdicts[static_cast<std::size_t>(verdict)]; }

std::optional<Verdict> verdictOf(std::string_view name) {
  for (std::size_t i = 0; i < kVerdicts.size(); ++i) {
    if (kVerdicts[i] == name) return static_cast<Verdict>(i);
  }
  return std::nullopt;
}

}  // namespace specs
