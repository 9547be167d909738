#pragma once

#include "metrics/area/area_metric.h"
#include "metrics/distributions/comparison.h"

namespace metrics {

/// Area validation metric for mixed uncertainty: by how much the measured box sticks out of the simulated one.
///
///   at level p        real  |--------------------|
///                     sim       |-----------|          d- = int_0^1 max(0, L_sim(p) - L_real(p)) dp
///                           | d-|           | d+ |     d+ = int_0^1 max(0, R_real(p) - R_sim(p)) dp
///
/// Where the boxes overlap, the AVM says 0; this says what the simulation fails to cover. Together the portions are
///
///   d+ + d- = area of the envelope of both boxes - area of the simulated box
///
/// so it is never below the AVM, equals it if the measurement is a single distribution, and is 0 exactly if the
/// simulated box covers the measured one. Unlike the AVM it keeps the triangle inequality for boxes, but it is not
/// symmetric: a wide simulation covers what a wide measurement would not excuse.
/// Both portions may be positive at once; the bias of AreaPortions then says which side lacks more.
/// Source: White & West 2019, "Area Validation Metric for Applications with Mixed Uncertainty", DATAWorks. The formula
/// is our reading of it; it reproduces all 30 examples that the Credibility Assessment Framework publishes ("NASA
/// AVM").
[[nodiscard]] AreaPortions whiteWestPortions(const Comparison& boxes);

}  // namespace metrics
