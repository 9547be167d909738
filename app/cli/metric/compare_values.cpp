#include <set>

#include "app/cli/metric/compare.h"
#include "core/csv.h"
#include "metrics/distributions/p_box.h"

namespace app {

namespace {

using Columns = std::vector<std::vector<double>>;

Columns readColumns(const std::string& file, const MetricRequest& request) {
  Columns columns = core::readNumericColumns(file, request.columns);
  if (columns.front().empty()) {
    throw core::InputError({.file = file}, "has a header and no rows; nothing can be compared.",
                           "Check the export, or leave the file out.");
  }
  return columns;
}

metrics::MetricOptions optionsOf(const MetricRequest& request) {
  return {.shift = request.shift == "balanced" ? metrics::Shift::Balanced : metrics::Shift::One,
          .experiments = request.experiments};
}

MeasurandResult emptyResult(const MetricRequest& request, std::size_t index) {
  return {.name = request.columns[index],
          .unit = request.unitOfColumn(index),
          .scale = request.scaleOfColumn(request.columns[index])};
}

/// Takes the numbers of column `index` out of the files.
MeasurandResult compareColumn(Columns& real, std::vector<Columns>& simulated, std::size_t index,
                              const MetricRequest& request, const MetricChoice<metrics::MetricInput>& choice) {
  MeasurandResult measurand = emptyResult(request, index);
  measurand.n_real = real[index].size();
  std::vector<double> pooled;
  std::vector<metrics::Edf> runs;
  for (Columns& run : simulated) {
    measurand.n_sim.push_back(run[index].size());
    if (simulated.size() > 1) pooled.insert(pooled.end(), run[index].begin(), run[index].end());
    runs.emplace_back(std::move(run[index]));
  }
  const metrics::Edf measured(std::move(real[index]));
  const metrics::PBox measured_box(measured);
  const metrics::PBox box = metrics::PBox::envelope(runs);
  if (simulated.size() > 1) runs = {metrics::Edf(std::move(pooled))};
  const metrics::MetricInput input({.simulated = box, .measured = measured_box},
                                   {.simulated = runs.front(), .measured = measured}, optionsOf(request));
  evaluate(choice, input, request, measurand);
  return measurand;
}

}  // namespace

std::vector<MeasurandResult> compareValues(const MetricRequest& request, const Session& session) {
  mustHaveColumns(request);
  (void)MetricSettings(request, {});
  const auto choice =
      choiceOf(metrics::metricCatalog(), request);  // a misspelt name is told before anything large is read
  Columns real = readColumns(request.real, request);
  std::vector<Columns> simulated;
  for (const std::string& file : request.simulated) {
    core::stopIfCancelled(session.progress);
    simulated.push_back(readColumns(file, request));
  }
  std::vector<MeasurandResult> measurands;
  for (std::size_t i = 0; i < request.columns.size(); ++i) {
    core::stopIfCancelled(session.progress);
    measurands.push_back(compareColumn(real, simulated, i, request, choice));
  }
  return measurands;
}

}  // namespace app
