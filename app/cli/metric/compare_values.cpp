#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "app/cli/metric/boxes.h"
#include "app/cli/metric/chance.h"
#include "app/cli/metric/compare.h"
#include "core/csv.h"
#include "metrics/distributions/box_bounds.h"

namespace app {

namespace {

using Columns = std::vector<std::vector<double>>;

/// The columns of one file, with the weight of each row and its unit of chance if they are asked for.
struct File {
  Columns columns;
  std::vector<double> weights;
  std::vector<std::uint32_t> units;
};

/// Numbers 0, 1, 2, … of frames or set-ups.
std::vector<std::uint32_t> unitsOf(const std::vector<double>& values, const std::string& file,
                                   const std::string& column) {
  std::vector<std::uint32_t> units;
  for (const double value : values) {
    if (value < 0.0 || value != std::floor(value) || value > std::numeric_limits<std::uint32_t>::max()) {
      throw core::InputError({.file = file, .item = "column '" + column + "'"},
                             fmt::format("{} is no number of a frame or set-up.", value),
                             "Units are numbered 0, 1, 2, …; name another column with --chance-unit.");
    }
    units.push_back(static_cast<std::uint32_t>(value));
  }
  return units;
}

/// Takes the last column; the file is read once for all of them.
std::vector<double> takenLast(Columns& columns) {
  std::vector<double> last = std::move(columns.back());
  columns.pop_back();
  return last;
}

File readColumns(const std::string& file, const MetricRequest& request) {
  std::vector<std::string> names = request.columns;
  if (!request.weights.empty()) names.push_back(request.weights);
  if (!request.chance_unit.empty()) names.push_back(request.chance_unit);
  File read{.columns = core::readNumericColumns(file, names), .weights = {}, .units = {}};
  if (!request.chance_unit.empty()) read.units = unitsOf(takenLast(read.columns), file, request.chance_unit);
  if (!request.weights.empty()) read.weights = takenLast(read.columns);
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

ChanceSamples samplesOf(const File& real, const std::vector<File>& simulated, std::size_t index) {
  ChanceSamples samples{.measured = {real.columns[index], real.units}, .simulated = {}};
  for (const File& run : simulated) samples.simulated.push_back({run.columns[index], run.units});
  return samples;
}

/// Takes the numbers of column `index` out of the file.
ColumnValues taken(File& file, std::size_t index) { return {std::move(file.columns[index]), file.weights}; }

void addLookUps(const Boxes& boxes, const MetricRequest& request, MeasurandResult& measurand) {
  for (const double p : request.at_levels) {
    measurand.look_ups.push_back(
        {true, p, metrics::quantileInterval(boxes.simulated, p), metrics::quantileInterval(boxes.measured, p)});
  }
  for (const double x : request.at_values) {
    measurand.look_ups.push_back(
        {false, x, metrics::probabilityInterval(boxes.simulated, x), metrics::probabilityInterval(boxes.measured, x)});
  }
}

MeasurandResult compareColumn(File& real, std::vector<File>& simulated, std::size_t index, const MetricRequest& request,
                              const Session& session, const MetricChoice<metrics::MetricInput>& choice) {
  MeasurandResult measurand = emptyResult(request, index);
  measurand.n_real = real.columns[index].size();
  for (const File& run : simulated) measurand.n_sim.push_back(run.columns[index].size());
  ChanceSamples samples;
  if (request.asksForChance()) samples = samplesOf(real, simulated, index);
  std::vector<ColumnValues> runs;
  for (File& run : simulated) runs.push_back(taken(run, index));
  const Boxes boxes = boxesOf(taken(real, index), std::move(runs), request);
  const metrics::MetricInput input({.simulated = boxes.simulated, .measured = boxes.measured},
                                   {.simulated = boxes.pooled, .measured = boxes.measured_sample},
                                   request.metricOptions());
  evaluate(choice, input, request, measurand);
  addLookUps(boxes, request, measurand);
  addChance(samples, request, session, measurand);
  return measurand;
}

void mustFitTogether(const MetricRequest& request) {
  if (!request.asksForChance() || !request.shapesBoxes()) return;
  throw core::InputError({.item = "--intervals, --floor, --half-width"},
                         "draw plain samples anew; they know no weights, margins, bands, mixtures or a-outer boxes.",
                         "Ask for one or the other.");
}

}  // namespace

std::vector<MeasurandResult> compareValues(const MetricRequest& request, const Session& session) {
  mustHaveColumns(request);
  mustFitTogether(request);
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
