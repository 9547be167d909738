#pragma once

#include "metrics/points/point_cloud.h"

namespace metrics {

/// Nearest-neighbour distances from one cloud to the other, added up. [m]
///
/// The published metric is the SUM: it grows with the number of points, so two sums compare only where that number is
/// the same. The means do not grow; their own weakness is that they say nothing about it.
struct CloudToCloud {
  double sum_of_simulated;  ///< over simulated points, to the nearest measured one
  double sum_of_measured;   ///< over measured points, to the nearest simulated one
  double mean_of_simulated;
  double mean_of_measured;
};

///   D(A, B) = sum_a min_b |a - b|
///
/// 0 in a direction does not mean equal clouds: a part of the other cloud has it too. Neither direction is a metric.
/// Throws InputError if a side has no point or a coordinate is not finite.
/// Source of the sum: Rosenberger 2022, Tab. 4-3; of the means as averaged directed Hausdorff distances:
/// Dubuisson & Jain 1994, doi:10.1109/ICPR.1994.576361.
[[nodiscard]] CloudToCloud cloudToCloud(const CloudPair& clouds);

}  // namespace metrics
