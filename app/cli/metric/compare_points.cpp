#include <cmath>

#include "app/cli/metric/compare.h"
#include "app/cli/metric/read.h"
#include "core/csv.h"
#include "metrics/points/point_metrics.h"

namespace app {

namespace {

using Cloud = std::vector<metrics::Position>;

const std::vector<std::string> kCartesian{"x_m", "y_m", "z_m"};
const std::vector<std::string> kSpherical{"range_m", "azimuth_rad", "elevation_rad"};

metrics::Position fromDirection(double range_m, double azimuth_rad, double elevation_rad) {
  return {.x_m = range_m * std::cos(elevation_rad) * std::cos(azimuth_rad),
          .y_m = range_m * std::cos(elevation_rad) * std::sin(azimuth_rad),
          .z_m = range_m * std::sin(elevation_rad)};
}

/// The columns that the file has: Cartesian if it has them, else those of a measurement.
std::vector<std::string> columnsOf(const std::string& file, const std::vector<std::string>& header) {
  if (hasColumns(header, kCartesian)) return kCartesian;
  if (hasColumns(header, kSpherical)) return kSpherical;
  throw core::InputError({.file = file, .line = 1},
                         "has neither x_m, y_m, z_m nor range_m, azimuth_rad, elevation_rad.",
                         "A point cloud needs one of both; its columns are " + core::join(header) + ".");
}

/// All frames, or one of them.
Cloud readCloud(const std::string& file, double frame) {
  const std::vector<std::string> header = headerOf(file);
  std::vector<std::string> names = columnsOf(file, header);
  const bool spherical = names == kSpherical;
  if (frame >= 0.0) names.emplace_back("frame");
  const auto columns = core::readNumericColumns(file, names);
  Cloud cloud;
  for (std::size_t i = 0; i < columns[0].size(); ++i) {
    if (frame >= 0.0 && columns[3][i] != frame) continue;
    cloud.push_back(spherical ? fromDirection(columns[0][i], columns[1][i], columns[2][i])
                              : metrics::Position{columns[0][i], columns[1][i], columns[2][i]});
  }
  return cloud;
}

}  // namespace

std::vector<MeasurandResult> comparePointClouds(const MetricRequest& request, const Session&) {
  mustHaveNoColumns(request);
  mustHaveOneSimulation(request);
  const MetricSettings settings(request, {{"frame", -1.0}, {"wasserstein_order", 1.0}, {"sliced_lines", 128.0}});
  const auto choice = choiceOf(metrics::pointMetrics(), request);
  const Cloud real = readCloud(request.real, settings["frame"]);
  const Cloud simulated = readCloud(request.simulated.front(), settings["frame"]);
  MeasurandResult measurand{.name = "points", .unit = "m", .n_real = real.size(), .n_sim = {simulated.size()}};
  const metrics::PointCloudInput input{
      .clouds = {.simulated = simulated, .measured = real},
      .options = {.wasserstein_order = settings["wasserstein_order"],
                  .slices = {.lines = settings.count("sliced_lines"), .seed = request.seed}}};
  evaluate(choice, input, request, measurand);
  return {std::move(measurand)};
}

}  // namespace app
