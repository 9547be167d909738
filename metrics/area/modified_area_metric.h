#pragma once

#include "metrics/area/area_metric.h"

namespace metrics {

/// What to add to a simulated value: the interval in which the truth lies. [unit of the measurand]
struct ModifiedArea {
  double lower;  ///< <= 0
  double upper;  ///< >= 0
};

/// Factor on the half width of the interval, larger the fewer experiments there are:
/// Fs = 1.25 + 1.2 (4 - 1.25) / n^(1/3). It is 4.55 for one experiment and 1.25 in the limit.
/// Throws InputError unless experiments > 0. Source: Voyles & Roy 2015, doi:10.2514/6.2015-1817.
[[nodiscard]] double safetyFactor(double experiments);

/// Modified area validation metric, d_MAVM = (d+ - d-)/2 -+ Fs (d+ + d-)/2. Its centre has the opposite sign of d_bias:
/// it corrects. With Fs = 1 it is [-d-, d+]. `experiments` counts replications of the experiment; detections of one
/// set-up that share its errors are fewer experiments than their number.
/// Source: Voyles & Roy 2015; Rosenberger 2022, eq. 9-4.
[[nodiscard]] ModifiedArea modifiedAreaMetric(const AreaPortions& portions, double experiments);

}  // namespace metrics
