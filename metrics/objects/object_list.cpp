#include "metrics/objects/object_list.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "core/error.h"

namespace metrics {

namespace {

[[noreturn]] void refuse(const char* side, std::size_t row, const std::string& problem) {
  throw core::InputError({.item = fmt::format("{} object {}", side, row)}, problem,
                         "Remove or correct it; nothing is dropped silently.");
}

void mustBeValid(std::span<const Object> list, const char* side) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    const auto& [id, p, footprint, existence] = list[i];
    if (!std::isfinite(p.x_m) || !std::isfinite(p.y_m) || !std::isfinite(p.z_m)) {
      refuse(side, i + 1, fmt::format("is at ({}, {}, {}) m; a position must be finite.", p.x_m, p.y_m, p.z_m));
    }
    if (!(existence >= 0.0 && existence <= 1.0)) {
      refuse(side, i + 1, fmt::format("exists with probability {}; it must be between 0 and 1.", existence));
    }
    if (!footprint) continue;
    const auto& [length, width, yaw] = *footprint;
    if (!std::isfinite(yaw)) refuse(side, i + 1, fmt::format("has the yaw {} rad; it must be finite.", yaw));
    if (!std::isfinite(length) || !std::isfinite(width) || length < 0.0 || width < 0.0) {
      refuse(side, i + 1, fmt::format("measures {} m x {} m; sizes must be finite and not negative.", length, width));
    }
  }
}

}  // namespace

void mustBeValid(const ObjectLists& lists) {
  mustBeValid(lists.simulated, "simulated");
  mustBeValid(lists.measured, "measured");
}

std::vector<Object> existing(std::span<const Object> list, double least_probability) {
  std::vector<Object> all;
  std::ranges::copy_if(list, std::back_inserter(all),
                       [&](const Object& object) { return object.existence >= least_probability; });
  return all;
}

CostTable positionDistances(const ObjectLists& lists) {
  return {lists.measured.size(), lists.simulated.size(), [&](std::size_t i, std::size_t j) {
            return distance(lists.measured[i].position, lists.simulated[j].position);
          }};
}

void mustBeValid(const SetOptions& options) {
  if (!(std::isfinite(options.order) && options.order >= 1.0)) {
    throw core::InputError({.item = "order of the metric"},
                           fmt::format("is {}; it must be finite and at least 1.", options.order),
                           "Take 1 (sum) or 2 (sum of squares).");
  }
  if (!(std::isfinite(options.cutoff_m) && options.cutoff_m > 0.0)) {
    throw core::InputError({.item = "cut-off of the metric"},
                           fmt::format("is {} m; it must be finite and positive.", options.cutoff_m),
                           "Take the distance from which on two objects are not the same.");
  }
}

void mustBePenalty(double value, const std::string& name) {
  if (std::isfinite(value) && value >= 0.0) return;
  throw core::InputError({.item = name}, fmt::format("is {} m; it must be finite and not negative.", value),
                         "Take 0 to leave it out.");
}

}  // namespace metrics
