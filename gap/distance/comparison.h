#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "gap/replay/cells.h"

namespace gap {

/// All beams, or every second one of each column and layer (to hold the rest out): whatever is a single beam wide, a
/// pole or an upright edge, has beams in both halves.
enum class Half { kAll, kEven, kOdd };

/// In what two sides are compared: whether there is an echo (and what those are like that no surface makes), and of
/// every channel how large the values are and how they scatter.
struct Aspects {
  bool existence = true;
  std::array<bool, kChannels> means = {true, true, true};
  std::array<bool, kChannels> spreads = {true, true, true};

  [[nodiscard]] bool ask(Channel channel) const { return means[channel] || spreads[channel]; }
};

/// Which cells of a sample take part, and in what.
struct Part {
  Half half = Half::kAll;
  bool edges = true;  ///< cells of beams at edges, too
  Aspects aspects = {};
};

/// Measured and simulated statistics of one sample, to be compared.
struct Comparison {
  std::size_t sample = 0;  ///< in the replay
  std::span<const CellStatistics> measured;
  int measured_frames = 1;
  std::vector<CellStatistics> simulated;
  int simulated_frames = 1;
};

/// Begin and end of so many nearly equal parts of a list, fewer if it is shorter.
[[nodiscard]] inline std::vector<std::pair<std::size_t, std::size_t>> evenParts(std::size_t size, std::size_t most) {
  std::vector<std::pair<std::size_t, std::size_t>> parts;
  const std::size_t count = std::min(most, size);
  for (std::size_t g = 0; g < count; ++g) parts.emplace_back(size * g / count, size * (g + 1) / count);
  return parts;
}

}  // namespace gap
