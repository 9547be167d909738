#include <cmath>
#include <fmt/format.h>

#include "app/cli/metric/compare.h"
#include "app/cli/metric/read.h"
#include "metrics/grids/grid_metrics.h"

namespace app {

namespace {

metrics::OccupancyGrid readGrid(const std::string& file, double cell_size_m) {
  Matrix matrix = readMatrix(file);
  for (std::size_t i = 0; i < matrix.cells.size(); ++i) {
    if (!std::isnan(matrix.cells[i])) continue;
    throw core::InputError(
        {.file = file, .item = fmt::format("row {}, column {}", i / matrix.columns + 1, i % matrix.columns + 1)},
        "is empty.", "Write 0.5 where it is unknown whether something stands there.");
  }
  return {matrix.rows, matrix.columns, cell_size_m, std::move(matrix.cells)};
}

}  // namespace

std::vector<MeasurandResult> compareOccupancyGrids(const MetricRequest& request, const Session&) {
  mustHaveNoColumns(request);
  mustHaveOneSimulation(request);
  const MetricSettings settings(
      request, {{"cell_size_m", 1.0}, {"occupied_above", 0.5}, {"free_below", 0.5}, {"clip", metrics::kUsualClip}});
  const auto choice = choiceOf(metrics::gridMetrics(), request);
  const metrics::OccupancyGrid real = readGrid(request.real, settings["cell_size_m"]);
  const metrics::OccupancyGrid simulated = readGrid(request.simulated.front(), settings["cell_size_m"]);
  MeasurandResult measurand{
      .name = "occupancy", .unit = "", .n_real = real.probabilities.size(), .n_sim = {simulated.probabilities.size()}};
  const metrics::GridInput input{
      .simulated = simulated,
      .measured = real,
      .limits = {.occupied_above = settings["occupied_above"], .free_below = settings["free_below"]},
      .clip = settings["clip"]};
  evaluate(choice, input, request, measurand);
  return {std::move(measurand)};
}

}  // namespace app
