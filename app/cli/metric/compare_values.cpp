#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "app/cli/metric/chance.h"
#include "app/cli/metric/compare.h"
#include "core/csv.h"
#include "metrics/distributions/p_box.h"

namespace app {

namespace {

using Columns = std::vector<std::vector<double>>;

/// The columns of one file, and the unit of each row if chance is asked for by units.
struct File {
  Columns columns;
  std::vector<std::uint32_t> units;
};

/// Numbers 0, 1, 2, … of frames or set-ups.
std::vector<std::uint32_t> unitsOf(const std::string& file, const std::string& column) {
  const std::vector<std::vector<double>> columns = core::readNumericColumns(file, std::vector{column});
  std::vector<std::uint32_t> units;
  for (const double value : columns.front()) {
    if (value < 0.0 || value != std::floor(value) || value > std::numeric_limits<std::uint32_t>::max()) {
      throw core::InputError({.file = file, .item = "column '" + column + "'"},
                             fmt::format("{} is no number of a frame or set-up.", value),
                             "Units are numbered 0, 1, 2, …; name another column with --chance-unit.");
    }
    units.push_back(static_cast<std::uint32_t>(value));
  }
  return units;
}

File readColumns(const std::string& file, const MetricRequest& request) {
  File read{.columns = core::readNumericColumns(file, request.columns), .units = {}};
  if (!request.chance_unit.empty()) read.units = unitsOf(file, request.chance_unit);
  if (read.columns.front().empty()) {
    throw core::InputError({.file = file}, "has a header and no rows; nothing can be compared.",
                           "Check the export, or leave the file out.");
  }
  return read;
}

MeasurandResult emptyResult(const MetricRequest& request, std::size_t index) {
  return {.name = request.columns[index],
          .unit = request.unitOfColumn(index),
          .scale = request.scaleOfColumn(request.columns[index])};
}

ChanceSamples samplesOf(File& real, std::vector<File>& simulated, std::size_t index) {
  ChanceSamples samples{.measured = {std::move(real.columns[index]), real.units}, .simulated = {}};
  for (File& run : simulated) samples.simulated.push_back({std::move(run.columns[index]), run.units});
  return samples;
}

/// Takes the numbers of column `index` out of the files.
MeasurandResult compareColumn(File& real, std::vector<File>& simulated, std::size_t index, const MetricRequest& request,
                              const Session& session, const MetricChoice<metrics::MetricInput>& choice) {
  MeasurandResult measurand = emptyResult(request, index);
  ChanceSamples samples = samplesOf(real, simulated, index);
  measurand.n_real = samples.measured.values.size();
  std::vector<double> pooled;
  std::vector<metrics::Edf> runs;
  const bool keep = request.asksForChance();
  for (ChanceSample& run : samples.simulated) {
    measurand.n_sim.push_back(run.values.size());
    if (simulated.size() > 1) pooled.insert(pooled.end(), run.values.begin(), run.values.end());
    runs.emplace_back(keep ? run.values : std::move(run.values));
  }
  const metrics::Edf measured(keep ? samples.measured.values : std::move(samples.measured.values));
  const metrics::PBox measured_box(measured);
  const metrics::PBox box = metrics::PBox::envelope(runs);
  if (simulated.size() > 1) runs = {metrics::Edf(std::move(pooled))};
  const metrics::MetricInput input({.simulated = box, .measured = measured_box},
                                   {.simulated = runs.front(), .measured = measured}, request.metricOptions());
  evaluate(choice, input, request, measurand);
  addChance(samples, request, session, measurand);
  return measurand;
}

}  // namespace

std::vector<MeasurandResult> compareValues(const MetricRequest& request, const Session& session) {
  mustHaveColumns(request);
  (void)MetricSettings(request, {});
  // A misspelt name is told before anything large is read.
  const auto choice = choiceOf(metrics::metricCatalog(), request);
  for (const auto& [name, half_width] : request.wantedHalfWidths()) (void)metrics::metricNamed(name);
  File real = readColumns(request.real, request);
  std::vector<File> simulated;
  for (const std::string& file : request.simulated) {
    core::stopIfCancelled(session.progress);
    simulated.push_back(readColumns(file, request));
  }
  std::vector<MeasurandResult> measurands;
  for (std::size_t i = 0; i < request.columns.size(); ++i) {
    core::stopIfCancelled(session.progress);
    measurands.push_back(compareColumn(real, simulated, i, request, session, choice));
  }
  return measurands;
}

}  // namespace app
