#include "metrics/metric_catalog.h"

#include <algorithm>
#include <string>

#include "core/error.h"
#include "core/text.h"
#include "metrics/area/double_metric.h"
#include "metrics/area/largest_area_metric.h"
#include "metrics/area/modified_area_metric.h"
#include "metrics/samples/kolmogorov_smirnov.h"
#include "metrics/samples/moment_differences.h"
#include "metrics/samples/wasserstein.h"

namespace metrics {

namespace {

using Input = MetricInput;
using Numbers = std::vector<double>;
constexpr auto kUnit = MetricUnit::Measurand;
constexpr auto kNumber = MetricShape::Number;
constexpr auto kList = MetricShape::List;

Numbers dvm(const Input& input) {
  const DoubleValidation& dvm = input.options.shift == Shift::One ? input.one_shift : input.balanced;
  return {dvm.bias, dvm.scatter};
}

Numbers bothEdges(const Input& input) {
  const DoubleMetric metric = doubleMetric(input.boxes);
  return {metric.left, metric.right};
}

Numbers mavm(const Input& input) {
  const ModifiedArea interval = modifiedAreaMetric(input.portions, input.experiments);
  return {interval.lower, interval.upper};
}

Numbers ks(const Input& input) {
  const KolmogorovSmirnov test = kolmogorovSmirnovTest(input.samples);
  return {test.statistic, test.p_value};
}

/// The list: one line a metric.
std::vector<Metric> makeCatalog() {
  return {
      {"d_avm",
       "area between the distributions; 0 where p-boxes overlap",
       kUnit,
       kNumber,
       {},
       [](const Input& in) { return Numbers{in.portions.area()}; }},
      {"d_plus",
       "part of it with simulated values too small",
       kUnit,
       kNumber,
       {},
       [](const Input& in) { return Numbers{in.portions.d_plus}; }},
      {"d_minus",
       "part of it with simulated values too large",
       kUnit,
       kNumber,
       {},
       [](const Input& in) { return Numbers{in.portions.d_minus}; }},
      {"d_bias",
       "d_minus - d_plus; > 0: simulation too high",
       kUnit,
       kNumber,
       {},
       [](const Input& in) { return Numbers{in.one_shift.bias}; }},
      {"d_cavm",
       "scatter: area left after the simulation is moved by -d_bias",
       kUnit,
       kNumber,
       {},
       [](const Input& in) { return Numbers{in.one_shift.scatter}; }},
      {"residual_bias",
       "bias left after that one shift; not 0 for p-boxes only",
       kUnit,
       kNumber,
       {},
       [](const Input& in) { return Numbers{in.one_shift.residual}; }},
      {"d_bias_balanced",
       "shift that leaves no bias",
       kUnit,
       kNumber,
       {},
       [](const Input& in) { return Numbers{in.balanced.bias}; }},
      {"d_cavm_balanced",
       "scatter: area left after the balanced shift",
       kUnit,
       kNumber,
       {},
       [](const Input& in) { return Numbers{in.balanced.scatter}; }},
      {"dvm", "double validation metric: bias and scatter", kUnit, kList, {"bias", "scatter"}, dvm},
      {"double_metric", "area between left edges, between right edges", kUnit, kList, {"left", "right"}, bothEdges},
      {"d_mavm", "interval to add to a simulated value, with safety factor", kUnit, kList, {"lower", "upper"}, mavm},
      {"d_avm_max",
       "largest area of any distribution inside the simulated p-box",
       kUnit,
       kNumber,
       {},
       [](const Input& in) { return Numbers{largestAreaMetric(in.boxes).area}; }},
      {"d_avm_max_error",
       "half width of what is known of it; 0: exact",
       kUnit,
       kNumber,
       {},
       [](const Input& in) { return Numbers{largestAreaMetric(in.boxes).error}; }},
      {"pbox_area",
       "mean width of the simulated p-box",
       kUnit,
       kNumber,
       {},
       [](const Input& in) { return Numbers{in.boxes.simulated.area()}; }},
      {"ks",
       "Kolmogorov-Smirnov test, pooled; p too large with ties",
       MetricUnit::None,
       MetricShape::Object,
       {"statistic", "p_value"},
       ks},
      {"wasserstein_1",
       "1-Wasserstein distance, pooled",
       kUnit,
       kNumber,
       {},
       [](const Input& in) { return Numbers{wassersteinDistance(in.samples)}; }},
      {"mean_difference",
       "simulated - measured mean, pooled",
       kUnit,
       kNumber,
       {},
       [](const Input& in) { return Numbers{meanDifference(in.samples)}; }},
      {"median_difference",
       "simulated - measured median, pooled",
       kUnit,
       kNumber,
       {},
       [](const Input& in) { return Numbers{medianDifference(in.samples)}; }},
      {"std_difference",
       "simulated - measured standard deviation (n - 1), pooled",
       kUnit,
       kNumber,
       {},
       [](const Input& in) { return Numbers{standardDeviationDifference(in.samples)}; }},
  };
}

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

std::span<const Metric> metricCatalog() {
  static const std::vector<Metric> catalog = makeCatalog();
  return catalog;
}

const Metric& metricNamed(std::string_view name) {
  std::vector<std::string> names;
  for (const Metric& metric : metricCatalog()) {
    if (metric.name == name) return metric;
    names.emplace_back(metric.name);
  }
  const std::string nearest = core::nearestName(name, names);
  throw core::InputError(
      {.item = "metric '" + std::string(name) + "'"}, "is not known.",
      nearest.empty() ? "The metrics are " + core::join(names) + "." : "Did you mean '" + nearest + "'?");
}

}  // namespace metrics
