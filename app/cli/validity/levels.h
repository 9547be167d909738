#pragma once

#include <string>
#include <vector>

#include "metrics/validity/ngo.h"

namespace app {

/// A metric of a fidelity level, as the user's file gives it.
struct LevelMetric {
  metrics::ScaledMetric metric;
  std::string unit;
  double scaled;  ///< value / maximum
};

struct Level {
  std::string name;
  std::vector<LevelMetric> metrics;
};

/// From CSV (level,metric,value,maximum and perhaps unit, one line a metric) or, if the name ends in .json,
/// "fidelis-levels". Levels in order of first appearance. Throws InputError with line or JSON Pointer.
[[nodiscard]] std::vector<Level> readLevels(const std::string& file);

}  // namespace app
