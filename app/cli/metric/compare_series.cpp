#include "app/cli/metric/compare.h"
#include "core/csv.h"
#include "metrics/series/series_metrics.h"

namespace app {

namespace {

std::optional<std::size_t> countSetting(const MetricSettings& settings, const std::string& name) {
  if (settings[name] < 0.0) return std::nullopt;  // the default: not given
  return settings.count(name);
}

}  // namespace

std::vector<MeasurandResult> compareSeries(const MetricRequest& request, const Session&) {
  mustHaveColumns(request);
  mustHaveOneSimulation(request);
  const MetricSettings settings(request, {{"largest_lag", -1.0}, {"warping_window", -1.0}});
  const auto choice = choiceOf(metrics::seriesMetrics(), request);
  const auto real = core::readNumericColumns(request.real, request.columns);
  const auto simulated = core::readNumericColumns(request.simulated.front(), request.columns);
  std::vector<MeasurandResult> measurands;
  for (std::size_t i = 0; i < request.columns.size(); ++i) {
    MeasurandResult measurand{.name = request.columns[i],
                              .unit = request.unitOfColumn(i),
                              .n_real = real[i].size(),
                              .n_sim = {simulated[i].size()},
                              .scale = request.scaleOfColumn(request.columns[i])};
    const metrics::SeriesInput input{.simulated = simulated[i],
                                     .measured = real[i],
                                     .times_s = {},
                                     .largest_lag = countSetting(settings, "largest_lag"),
                                     .warping_window = countSetting(settings, "warping_window")};
    evaluate(choice, input, request, measurand);
    measurands.push_back(std::move(measurand));
  }
  return measurands;
}

}  // namespace app
