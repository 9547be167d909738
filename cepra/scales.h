#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cepra {

struct ScaleLevel {
  int value = 0;  ///< 1 ... 10
  std::string label;
  std::string description;
};

/// What the numbers 1 ... 10 mean.
struct Scale {
  std::string id;  ///< "occurrence" or "impact"
  std::string title;
  std::string question;            ///< what the expert is asked
  std::string source;              ///< who worded it, after which method
  std::vector<ScaleLevel> levels;  ///< ten, ascending

  /// The level of a value from 1 to 10.
  [[nodiscard]] const ScaleLevel& level(int value) const { return levels.at(static_cast<std::size_t>(value - 1)); }
};

struct Scales {
  Scale occurrence;
  Scale impact;
};

/// Reads occurrence.json and impact.json from a folder (default: scales/ of the resources). Throws InputError for
/// a missing file, an unknown key, or levels that are not exactly 1 ... 10.
[[nodiscard]] Scales readScales();
[[nodiscard]] Scales readScales(const std::filesystem::path& folder);

}  // namespace cepra
