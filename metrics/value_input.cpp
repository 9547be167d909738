#include "metrics/value_input.h"

#include "metrics/area/modified_area_metric.h"

namespace metrics {

namespace {

double experimentsOf(const SamplePair& samples, const MetricOptions& options) {
  const double n = options.experiments.value_or(samples.measured.effectiveN());
  (void)safetyFactor(n);  // refuses what no metric could use
  return n;
}

}  // namespace

MetricInput::MetricInput(const Comparison& compared, const SamplePair& pooled, const MetricOptions& chosen)
    : boxes(compared),
      samples(pooled),
      options(chosen),
      experiments(experimentsOf(pooled, chosen)),
      portions(areaPortions(compared)),
      one_shift(doubleValidationMetric(compared, Shift::One)),
      balanced(doubleValidationMetric(compared, Shift::Balanced)) {}

}  // namespace metrics
