#pragma once

#include <string>
#include <vector>

#include "app/cli/metric/request.h"
#include "core/error.h"
#include "core/text.h"
#include "metrics/metric_catalog.h"

namespace app {

/// One metric with what it gave.
struct MetricResult {
  metrics::MetricInfo info;
  metrics::MetricShape shape = metrics::MetricShape::Number;
  std::vector<std::string_view> parts;
  std::vector<double> numbers;
};

/// The metrics of one measurand (a column, a cloud, a grid, …), with what a reader needs to judge them.
struct MeasurandResult {
  std::string name;
  std::string unit;
  std::size_t n_real = 0;
  std::vector<std::size_t> n_sim;
  metrics::Scale scale = metrics::Scale::Ratio;
  std::vector<MetricResult> results;
  std::vector<std::string_view> left_out;  ///< metrics that this scale of measurement does not allow
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

/// Computes the chosen metrics into `measurand`. One that asks more than the scale gives is left out and named there;
/// if it was asked for by name it throws InputError.
template <typename Input>
void evaluate(const MetricChoice<Input>& choice, const Input& input, const MetricRequest& request,
              MeasurandResult& measurand) {
  for (const auto* metric : choice) {
    if (metrics::isMeaningful(metric->info, measurand.scale)) {
      measurand.results.push_back({metric->info, metric->shape, metric->parts, metric->compute(input)});
      continue;
    }
    measurand.left_out.push_back(metric->info.name);
    if (request.metrics.empty()) continue;
    throw core::InputError(
        {.item = "metric '" + std::string(metric->info.name) + "'"},
        "needs an " + std::string(metrics::toString(metric->info.scale)) + " scale, and " + measurand.name + " is " +
            std::string(metrics::toString(measurand.scale)) + ".",
        "Differences of ranks or names mean nothing. Use a metric of ranks, such as ks, or correct --scale.");
  }
}

}  // namespace app
