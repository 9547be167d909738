#include "metrics/points/extent.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "metrics/distributions/summation.h"

namespace metrics {

namespace {

struct Box {
  Position low;
  Position high;
};

Box boundingBox(std::span<const Position> cloud) {
  Box box{.low = cloud.front(), .high = cloud.front()};
  for (const Position& p : cloud) {
    box.low = {std::min(box.low.x_m, p.x_m), std::min(box.low.y_m, p.y_m), std::min(box.low.z_m, p.z_m)};
    box.high = {std::max(box.high.x_m, p.x_m), std::max(box.high.y_m, p.y_m), std::max(box.high.z_m, p.z_m)};
  }
  return box;
}

Position difference(const Position& a, const Position& b) { return {a.x_m - b.x_m, a.y_m - b.y_m, a.z_m - b.z_m}; }

Position halfSum(const Position& a, const Position& b) {
  return {0.5 * (a.x_m + b.x_m), 0.5 * (a.y_m + b.y_m), 0.5 * (a.z_m + b.z_m)};
}

double largestMagnitude(const Position& p) { return std::max({std::abs(p.x_m), std::abs(p.y_m), std::abs(p.z_m)}); }

}  // namespace

Position centreOfGravity(std::span<const Position> cloud) noexcept {
  Summation x;
  Summation y;
  Summation z;
  for (const Position& p : cloud) {
    x.add(p.x_m);
    y.add(p.y_m);
    z.add(p.z_m);
  }
  const auto n = static_cast<double>(cloud.size());
  return {x.value() / n, y.value() / n, z.value() / n};
}

double centreOfGravityDistance(const CloudPair& clouds) {
  mustHavePoints(clouds);
  return distance(centreOfGravity(clouds.simulated), centreOfGravity(clouds.measured));
}

BoundingBoxError boundingBoxError(const CloudPair& clouds) {
  mustHavePoints(clouds);
  const Box simulated = boundingBox(clouds.simulated);
  const Box measured = boundingBox(clouds.measured);
  const Position low = difference(simulated.low, measured.low);
  const Position high = difference(simulated.high, measured.high);
  return {.size = difference(high, low),
          .centre = halfSum(low, high),
          .face = std::max(largestMagnitude(low), largestMagnitude(high))};
}

double pointCountRatio(const CloudPair& clouds) noexcept {
  if (clouds.measured.empty()) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(clouds.simulated.size()) / static_cast<double>(clouds.measured.size());
}

}  // namespace metrics
