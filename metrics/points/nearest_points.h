#pragma once

#include <vector>

#include "metrics/points/point_cloud.h"

namespace metrics {

/// Of every point of `from`, in its order, the distance to the nearest point of `to`. [m]
/// A k-d tree: O((n + m) log m). `to` must have a point; coordinates must be finite.
[[nodiscard]] std::vector<double> nearestDistances(std::span<const Position> from, std::span<const Position> to);

/// Both directions at once. Throws InputError as mustHavePoints does.
struct NearestDistances {
  std::vector<double> of_simulated;  ///< to the nearest measured point
  std::vector<double> of_measured;   ///< to the nearest simulated point
};

[[nodiscard]] NearestDistances nearestDistances(const CloudPair& clouds);

}  // namespace metrics
