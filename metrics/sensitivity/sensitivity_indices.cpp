#include "metrics/sensitivity/sensitivity_indices.h"

#include <cmath>
#include <fmt/format.h>

#include "core/error.h"

namespace metrics {

void mustBeFinite(std::span<const double> outputs) {
  for (std::size_t row = 0; row < outputs.size(); ++row) {
    if (std::isfinite(outputs[row])) continue;
    throw core::InputError({.item = fmt::format("output {}", row + 1)},
                           fmt::format("is {}; indices need finite numbers.", outputs[row]),
                           "Narrow the ranges until the model gives an output everywhere.");
  }
}

}  // namespace metrics
