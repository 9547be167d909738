#pragma once

#include <string>
#include <vector>

#include "gap/replay/replay.h"
#include "gap/where/residual_tables.h"

namespace gap {

/// Measured minus simulated over the beams of one sample, for a map. Large scans are averaged over neighbouring beams.
struct ResidualMap {
  struct Point {
    double azimuth_deg;
    std::size_t row;  ///< in `rows`
    double value;     ///< NaN: a beam was fired there, and neither side has data
  };
  std::string measurand;
  std::string component;  ///< "bias" (of the mean), "scatter", "missing" or "extra"
  std::string unit;
  std::string sample;
  double azimuth_step_deg = 1.0;
  std::vector<std::string> rows;  ///< what they are called, lowest elevation first
  std::vector<Point> points;
};

/// Values of one measurand in one held-out sample, for curves.
struct BeforeAfterValues {
  std::string measurand;
  std::string unit;
  std::string sample;
  std::vector<double> measured;
  std::vector<double> before;
  std::vector<double> after;  ///< empty if no cause was added
};

/// Maps of every measurand that deviates: of up to three samples in which it deviates most, both components of each
/// (bias and scatter, or missing and extra).
[[nodiscard]] std::vector<ResidualMap> residualMaps(const Replay& replay, const std::vector<ResidualTable>& tables);

/// Values for curves of the measurand that deviates most, of up to three held-out samples.
[[nodiscard]] std::vector<BeforeAfterValues> beforeAfterValues(const Replay& replay,
                                                               const std::vector<ResidualTable>& tables,
                                                               const std::vector<std::size_t>& held_out,
                                                               const World* after, std::uint64_t seed);

}  // namespace gap
