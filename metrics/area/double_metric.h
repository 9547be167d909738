#pragma once

#include "metrics/distributions/comparison.h"

namespace metrics {

/// Both >= 0, in the unit of the measurand.
struct DoubleMetric {
  double left;   ///< area between the left edges
  double right;  ///< area between the right edges
};

/// Double metric: edge against edge, so that a wide box is not rewarded for covering the measurement.
/// A simulation known to +-w about an EDF has max(left, right) >= w + |difference of means|.
/// The area is unsigned; the sign of the deviation is d_bias. Source: as "double metric" in Rosenberger 2022, eq. 8-11,
/// after Danquah.
[[nodiscard]] DoubleMetric doubleMetric(const Comparison& boxes);

}  // namespace metrics
