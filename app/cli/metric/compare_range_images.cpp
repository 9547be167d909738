#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "app/cli/metric/compare.h"
#include "app/cli/metric/read.h"
#include "core/csv.h"
#include "metrics/grids/grid_metrics.h"

namespace app {

namespace {

const std::vector<std::string> kMeasurement{"layer", "azimuth_rad", "range_m"};

/// Beams whose azimuths differ by less are the same beam.
constexpr double kSameBeam_rad = 1e-6;

/// A pixel: layer, and azimuth in steps of kSameBeam_rad.
using Beam = std::pair<long long, long long>;
using Echoes = std::map<Beam, double>;

/// The nearest echo of every beam of one frame.
Echoes readEchoes(const std::string& file, double frame) {
  std::vector<std::string> names = kMeasurement;
  const bool has_frames = hasColumns(headerOf(file), {"frame"});
  if (has_frames) names.emplace_back("frame");
  const auto columns = core::readNumericColumns(file, names);
  Echoes echoes;
  for (std::size_t i = 0; i < columns[0].size(); ++i) {
    if (has_frames && columns[3][i] != frame) continue;
    const Beam beam{std::llround(columns[0][i]), std::llround(columns[1][i] / kSameBeam_rad)};
    const auto [echo, is_new] = echoes.try_emplace(beam, columns[2][i]);
    if (!is_new) echo->second = std::min(echo->second, columns[2][i]);
  }
  return echoes;
}

/// One pixel for every layer and every azimuth that either side has; left is the largest azimuth.
struct Pixels {
  std::vector<long long> layers;
  std::vector<long long> azimuths;
};

Pixels pixelsOf(const Echoes& a, const Echoes& b) {
  std::set<long long> layers;
  std::set<long long, std::greater<>> azimuths;
  for (const Echoes* echoes : {&a, &b}) {
    for (const auto& [beam, range] : *echoes) {
      layers.insert(beam.first);
      azimuths.insert(beam.second);
    }
  }
  return {{layers.begin(), layers.end()}, {azimuths.begin(), azimuths.end()}};
}

metrics::RangeImage imageOf(const Echoes& echoes, const Pixels& pixels) {
  metrics::RangeImage image{pixels.layers.size(), pixels.azimuths.size(), {}};
  for (const long long layer : pixels.layers) {
    for (const long long azimuth : pixels.azimuths) {
      const auto echo = echoes.find({layer, azimuth});
      image.range_m.push_back(echo == echoes.end() ? std::numeric_limits<double>::quiet_NaN() : echo->second);
    }
  }
  return image;
}

metrics::RangeImage readImage(const std::string& file) {
  Matrix matrix = readMatrix(file);
  return {matrix.rows, matrix.columns, std::move(matrix.cells)};
}

std::size_t echoCount(const metrics::RangeImage& image) {
  return static_cast<std::size_t>(
      std::count_if(image.range_m.begin(), image.range_m.end(), [](double r) { return !std::isnan(r); }));
}

}  // namespace

std::vector<MeasurandResult> compareRangeImages(const MetricRequest& request, const Session&) {
  mustHaveNoColumns(request);
  mustHaveOneSimulation(request);
  const MetricSettings settings(request, {{"frame", 0.0}});
  const auto choice = choiceOf(metrics::rangeImageMetrics(), request);
  metrics::RangeImage real, simulated;
  if (hasColumns(headerOf(request.real), kMeasurement)) {
    const Echoes real_echoes = readEchoes(request.real, settings["frame"]);
    const Echoes simulated_echoes = readEchoes(request.simulated.front(), settings["frame"]);
    const Pixels pixels = pixelsOf(real_echoes, simulated_echoes);
    real = imageOf(real_echoes, pixels);
    simulated = imageOf(simulated_echoes, pixels);
  } else {
    real = readImage(request.real);
    simulated = readImage(request.simulated.front());
  }
  MeasurandResult measurand{
      .name = "range_image", .unit = "m", .n_real = echoCount(real), .n_sim = {echoCount(simulated)}};
  const metrics::RangeImageInput input{.simulated = simulated, .measured = real};
  evaluate(choice, input, request, measurand);
  return {std::move(measurand)};
}

}  // namespace app
