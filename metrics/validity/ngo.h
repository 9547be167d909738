#pragma once

#include <span>
#include <string>
#include <vector>

namespace metrics {

/// A distance-like metric with its scale: 0 is best, `maximum` counts as 1.
struct ScaledMetric {
  std::string name;
  double value;
  double maximum;  ///< largest value among the compared models, or one that is as bad as can be
};

/// One level of looking at a sensor model; the sensor's raw data are seen at the explicit levels, what an application
/// makes of them at the implicit ones.
struct FidelityLevel {
  std::string name;
  std::vector<ScaledMetric> metrics;
};

/// 0: no gap at any level, 1: as large as the scales go at every level. No unit.
struct NgoGap {
  double gap;
  std::vector<double> levels;  ///< mean of each level's metrics, in [0, 1]
};

/// Simulation-to-reality gap over fidelity levels: the mean of the levels' means of value / maximum.
///
///   level   metrics taken for a radar model
///   I       OSPA, 1 - IoU
///   II      RMSE of x and y, cardinality
///   III     1-Wasserstein, point pattern
///   IV      1-Wasserstein of range, azimuth and Doppler, number of detections
///
/// Every level weighs the same, however many metrics it has. The maxima are not fixed by the paper: they are inputs,
/// and gaps with different maxima must not be compared. Similarities (1 is best) are to be given as 1 - value.
/// Throws InputError without a level or for a level without metrics, and unless 0 <= value <= maximum, maximum > 0.
/// Source: Ngo, Bauer & Resch 2021, A multi-layered approach for measuring the simulation-to-reality gap of radar
/// perception for autonomous driving, arXiv:2106.08372; levels as summarised by Rosenberger 2022.
[[nodiscard]] NgoGap ngoGap(std::span<const FidelityLevel> levels);

}  // namespace metrics
