#pragma once

#include "metrics/points/point_cloud.h"

namespace metrics {

/// How far the farthest straggler of one cloud is from the other cloud. [m]
struct Hausdorff {
  double of_simulated;  ///< max over simulated points of the distance to the nearest measured one
  double of_measured;   ///< max over measured points of the distance to the nearest simulated one

  /// The larger of both: a metric on finite sets. One outlier decides it.
  [[nodiscard]] double distance() const noexcept { return of_simulated > of_measured ? of_simulated : of_measured; }
};

///   h(A, B) = max_a min_b |a - b|        H = max(h(A, B), h(B, A))
///
/// Throws InputError if a side has no point or a coordinate is not finite.
/// Source: Huttenlocher, Klanderman & Rucklidge 1993, doi:10.1109/34.232073.
[[nodiscard]] Hausdorff hausdorff(const CloudPair& clouds);

}  // namespace metrics
