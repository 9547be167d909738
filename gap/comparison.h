#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "gap/cells.h"

namespace gap {

/// All beam columns, or every second one (to hold the rest out).
enum class Half { kAll, kEven, kOdd };

/// Which cells of a sample take part.
struct Part {
  Half half = Half::kAll;
  bool edges = true;  ///< cells of beams at edges, too
};

/// Measured and simulated statistics of one sample, to be compared.
struct Comparison {
  std::size_t sample = 0;  ///< in the replay
  std::span<const CellStatistics> measured;
  int measured_frames = 1;
  std::vector<CellStatistics> simulated;
  int simulated_frames = 1;
};

}  // namespace gap
