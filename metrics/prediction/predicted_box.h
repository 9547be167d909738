#pragma once

#include <optional>

#include "metrics/distributions/p_box.h"
#include "metrics/prediction/prediction.h"

namespace metrics {

/// What the simulation and its predicted error say of reality at one point.
///
///   expected   simulation moved by -d_bias, then widened by d_CAVM on either side
///   bound      the same for every d_bias and d_CAVM between their bounds:
///
///     left    L - bias.high - scatter.high         L, R  quantiles of the edges of the simulated box
///     right   R - bias.low  + scatter.high
///
///   p 1 |    .   ___       ___   .
///       |  . ___|  sim - bias |___ .        dots: bound, steps: expected
///     0 |_.__|__________________|__.__ x   [unit of the measurand]
///
/// Moving by -d_bias and reporting both parts at bounds is Rosenberger's use of the metric (2023, ch. 9; the sign as in
/// double_validation_metric.h). The full d_CAVM on both sides is our choice, the cautious one: as Roy & Oberkampf 2011,
/// doi:10.1016/j.cma.2011.03.016, append an area. Half of it a side would be d+ and d- of an EDF after correction.
struct PredictedBox {
  PBox expected;
  std::optional<PBox> bound;  ///< absent if a bound is infinite: no degrees of freedom
};

/// Confidence: bounds of the mean error. Observation: of the error that one more sample would show.
enum class BoundOf { Confidence, Observation };

/// What was predicted at the point at which `simulated` was obtained.
struct PredictedErrors {
  const PredictedError& bias;     ///< of d_bias
  const PredictedError& scatter;  ///< of d_CAVM
};
[[nodiscard]] PredictedBox predictedBox(const PBox& simulated, const PredictedErrors& errors,
                                        BoundOf bound = BoundOf::Confidence);

}  // namespace metrics
