#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "core/detections.h"
#include "model/experiment.h"

namespace gap {

/// Bias and scatter error of one measurand over the pooled detections of a sample (DVM, formats.md section 5: d_bias is
/// positive when the simulation is too high). [unit of the measurand]
struct MeasurandGap {
  std::string name;
  std::string unit;
  double d_bias = 0.0;
  double d_cavm = 0.0;
  double resolution = 1.0;

  [[nodiscard]] double steps() const { return (std::abs(d_bias) + d_cavm) / resolution; }
};

/// What all echoes missing, or as many extra, add to the total gap.
inline constexpr double kExistenceWeight = 100.0;

/// The gap of one sample, or the mean over several, as formats.md section 6 defines it.
struct TotalGap {
  std::vector<MeasurandGap> measurands;
  double missing_fraction = 0.0;  ///< simulated echoes that were not measured, share of all simulated
  double extra_fraction = 0.0;
  double total = 0.0;  ///< Σ (|d_bias| + d_cavm)/resolution + kExistenceWeight (missing + extra)
};

/// One sample; measurands whose column either side lacks are left out. Without recorded directions existence is no
/// measurand.
[[nodiscard]] TotalGap totalGap(const std::vector<model::Measurand>& measurands, const core::Detections& measured,
                                const core::Detections& simulated, int frames);

/// Means over samples (d_bias with its sign; `total` is the mean of the totals).
[[nodiscard]] TotalGap meanOf(const std::vector<TotalGap>& gaps);

/// What measurands that can no longer be compared added to the gap before: who reports nothing is not better for it.
[[nodiscard]] double ofMeasurandsLostIn(const TotalGap& after, const TotalGap& before);

/// The detections of some frames only, each as often as it is listed (for a bootstrap over frames).
[[nodiscard]] core::Detections framesOf(const core::Detections& detections, const std::vector<int>& frames);

}  // namespace gap
