#pragma once

#include "metrics/area/area_metric.h"
#include "metrics/distributions/comparison.h"

namespace metrics {

/// The portions of the area metric, summed along the values instead of along the levels:
///
///   d+ = int max(0, F_sim,right(x) - F_real,left(x)) dx     d- = int max(0, F_real,right(x) - F_sim,left(x)) dx
///
/// The same area cut into upright strips, so the same numbers as areaPortions but for rounding: the check of one by
/// the other, independent of level_walk.h. Use areaPortions; this one knows no shift.
/// Source: Vallender 1974, doi:10.1137/1118101.
[[nodiscard]] AreaPortions areaPortionsOverValues(const Comparison& boxes);

}  // namespace metrics
