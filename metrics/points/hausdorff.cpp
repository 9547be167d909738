#include "metrics/points/hausdorff.h"

#include <algorithm>

#include "metrics/points/nearest_points.h"

namespace metrics {

Hausdorff hausdorff(const CloudPair& clouds) {
  const NearestDistances nearest = nearestDistances(clouds);
  return {.of_simulated = std::ranges::max(nearest.of_simulated), .of_measured = std::ranges::max(nearest.of_measured)};
}

}  // namespace metrics
