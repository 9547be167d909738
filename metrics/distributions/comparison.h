#pragma once

#include "metrics/distributions/edf.h"
#include "metrics/distributions/p_box.h"

namespace metrics {

/// What is compared; the names keep the sides from being exchanged. An Edf is a PBox of width 0:
/// areaValidationMetric({.simulated = box, .measured = edf}). Referred to, not owned: use it within one expression.
struct Comparison {
  const PBox& simulated;
  const PBox& measured;
};

/// Two samples, for metrics that know no p-box. Several simulated runs are pooled into one sample.
struct SamplePair {
  const Edf& simulated;
  const Edf& measured;
};

}  // namespace metrics
