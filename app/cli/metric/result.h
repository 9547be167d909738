#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/metric/request.h"
#include "core/error.h"
#include "core/text.h"
#include "metrics/distributions/interval.h"
#include "metrics/metric_catalog.h"
#include "metrics/resampling/intervals.h"

namespace app {

/// One metric with what it gave.
struct MetricResult {
  metrics::MetricInfo info;
  metrics::MetricShape shape = metrics::MetricShape::Number;
  std::vector<std::string_view> parts;
  std::vector<double> numbers;
  std::vector<metrics::ConfidenceInterval> intervals;  ///< parallel to the numbers; empty without a bootstrap
};

/// What a metric is by chance alone, at these numbers of values.
struct FloorResult {
  std::string_view name;
  std::optional<double> perfect_median;  ///< of a model that draws from the measured distribution: limits below fail
  double median;                         ///< of both sides dealt out anew; judges what was observed
  double high;                           ///< 95 % of chance stays below
  std::optional<double> p_value;
};

/// How many times the data are needed for an interval of a wanted half width.
struct RepetitionResult {
  std::string_view name;
  double half_width;
  double factor;
  double low;
  double high;
  double measured_share;  ///< of the variance, that repeating the measurement can lower; NaN if paired
};

/// What a p-box says at a level or at a value; both sides. low = high for a single distribution.
struct LookUp {
  bool at_level = false;  ///< true: quantiles at a level; false: probabilities at a value
  double at = 0.0;
  metrics::Interval simulated;
  metrics::Interval measured;
};

/// A metric that these data do not allow, and why.
struct LeftOut {
  std::string_view name;
  std::string reason;
};

/// The metrics of one measurand (a column, a cloud, a grid, …), with what a reader needs to judge them.
struct MeasurandResult {
  std::string name;
  std::string unit;
  std::size_t n_real = 0;
  std::vector<std::size_t> n_sim;
  metrics::Scale scale = metrics::Scale::Ratio;
  std::vector<MetricResult> results;
  std::vector<LeftOut> left_out;
  std::vector<LookUp> look_ups;
  std::vector<FloorResult> floors;
  std::vector<RepetitionResult> repetitions;
};

template <typename Input>
using MetricChoice = std::vector<const metrics::MetricOf<Input>*>;

/// Throws InputError for a name that is not in a list: it belongs to another kind of data, or it is misspelt.
[[noreturn]] void throwUnknownMetric(const std::string& name, const std::string& data,
                                     const std::vector<std::string>& known);

/// The metrics that were asked for by name, in that order; without names all that are not told on request only.
template <typename Input>
MetricChoice<Input> choiceOf(std::span<const metrics::MetricOf<Input>> list, const MetricRequest& request) {
  MetricChoice<Input> choice;
  std::vector<std::string> known;
  for (const auto& metric : list) {
    known.emplace_back(metric.info.name);
    if (request.metrics.empty() && !metric.info.on_request) choice.push_back(&metric);
  }
  for (const std::string& name : request.metrics) {
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end()) throwUnknownMetric(name, request.data, known);
    choice.push_back(&list[static_cast<std::size_t>(found - known.begin())]);
  }
  return choice;
}

/// Why a metric means nothing on data of this scale; nothing if it does.
[[nodiscard]] std::optional<core::InputError> scaleError(const metrics::MetricInfo& info,
                                                         const MeasurandResult& measurand);

/// Computes the chosen metrics into `measurand`. What was asked for by name must work; otherwise a metric that the data
/// do not allow (scale, number of points, unequal lengths) is left out with the reason, as long as any metric works.
template <typename Input>
void evaluate(const MetricChoice<Input>& choice, const Input& input, const MetricRequest& request,
              MeasurandResult& measurand) {
  std::optional<core::InputError> first;
  for (const auto* metric : choice) {
    try {
      if (const auto error = scaleError(metric->info, measurand)) throw *error;
      measurand.results.push_back({metric->info, metric->shape, metric->parts, metric->compute(input)});
    } catch (const core::InputError& error) {
      if (!request.metrics.empty()) throw;
      if (!first) first = error;
      measurand.left_out.push_back({metric->info.name, error.problem()});
    }
  }
  if (measurand.results.empty() && first) throw *first;
}

}  // namespace app
