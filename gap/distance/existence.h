#pragma once

#include <cstddef>

#include "core/detections.h"

namespace gap {

/// Detections of a number of repeated frames.
struct Frames {
  const core::Detections& detections;
  int count;  ///< frames recorded or simulated, also those without a detection; > 0
};

/// Where one side sees echoes that the other does not, summed over cells of a layer and 2° of azimuth. Both are shares
/// of all simulated echoes, so `extra` may exceed 1; both are NaN if nothing was simulated.
struct ExistenceGap {
  double missing;  ///< simulated but not measured
  double extra;    ///< measured but not simulated
};

/// Without recorded directions the whole sample is one cell.
[[nodiscard]] ExistenceGap existenceGap(const Frames& simulated, const Frames& measured);

/// Share of the fired beams that gave at least one echo. Without recorded directions first echoes are counted.
[[nodiscard]] double detectionRate(const Frames& frames, std::size_t beams_per_frame);

}  // namespace gap
