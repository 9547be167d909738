#include "metrics/points/point_cloud.h"

#include <cmath>
#include <fmt/format.h>

#include "core/error.h"

namespace metrics {

namespace {

void mustBeFinite(std::span<const Position> cloud, const char* side) {
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Position& p = cloud[i];
    if (std::isfinite(p.x_m) && std::isfinite(p.y_m) && std::isfinite(p.z_m)) continue;
    throw core::InputError({.item = fmt::format("{} point {}", side, i + 1)},
                           fmt::format("is ({}, {}, {}) m; a point needs finite coordinates.", p.x_m, p.y_m, p.z_m),
                           "Remove or correct it; nothing is dropped silently.");
  }
}

void mustHavePoints(std::span<const Position> cloud, const char* side) {
  if (!cloud.empty()) return;
  throw core::InputError({.item = fmt::format("{} points", side)},
                         "are none; there is no distance to an empty point cloud.",
                         "Check the gate or the file, or compare numbers of points instead.");
}

}  // namespace

double distance(const Position& a, const Position& b) noexcept {
  return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m, a.z_m - b.z_m);
}

void mustBeFinite(const CloudPair& clouds) {
  mustBeFinite(clouds.simulated, "simulated");
  mustBeFinite(clouds.measured, "measured");
}

void mustHavePoints(const CloudPair& clouds) {
  mustHavePoints(clouds.simulated, "simulated");
  mustHavePoints(clouds.measured, "measured");
  mustBeFinite(clouds);
}

}  // namespace metrics
