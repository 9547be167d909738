#pragma once

#include <cstdint>
#include <vector>

#include "core/random.h"

namespace metrics_test {

/// Independent draws; each index is a sample of its own.
inline std::vector<double> normalSample(std::uint32_t index, std::size_t n, double mean = 0.0, double deviation = 1.0) {
  core::Random random({.seed = 9, .sample = index, .purpose = core::purposeOf("normalSample")});
  std::vector<double> values(n);
  for (double& x : values) x = mean + deviation * random.normal();
  return values;
}

}  // namespace metrics_test
