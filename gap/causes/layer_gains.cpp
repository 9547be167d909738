#include "gap/causes/layer_gains.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/physics.h"
#include "gap/replay/statistics.h"

namespace gap {

namespace {

constexpr int kFrames = 6;
constexpr std::size_t kFewestCells = 5;
constexpr double kSharedByChance = 1e-3;  // that the gains of layers, each its own, have such a mean

/// Logarithm of the ratio of the received powers.
double logRatio(const CellStatistics& measured, const CellStatistics& simulated, Channel channel, double pulse_m) {
  const double m = measured.mean(channel), s = simulated.mean(channel);
  return channel == kIntensity ? std::log(m / s) : std::log(2.0) * (m * m - s * s) / (pulse_m * pulse_m);
}

std::vector<std::size_t> samplesOf(const Replay& replay, const std::vector<std::string>& sensors, bool held_out) {
  std::vector<std::size_t> samples;
  for (std::size_t s = 0; s < replay.samples().size(); ++s) {
    const model::Sample& sample = *replay.samples()[s].sample;
    const bool by_one_of_them = std::find(sensors.begin(), sensors.end(), sample.sensor) != sensors.end();
    if (!by_one_of_them || replay.samples()[s].layout->pooled()) continue;
    if (held_out == (sample.role == model::Role::kPrediction)) samples.push_back(s);
  }
  return samples;
}

/// How many layers each of the sensors has; 0 if not all have as many.
std::size_t layersOf(const Replay& replay, const std::vector<std::string>& sensors) {
  const auto of = [&](const std::string& sensor) { return replay.baseline().model.sensor(sensor).scan.layers.size(); };
  const std::size_t layers = of(sensors.front());
  const bool alike = std::all_of(sensors.begin(), sensors.end(), [&](const std::string& s) { return of(s) == layers; });
  return alike ? layers : 0;
}

}  // namespace

std::vector<double> layerGains(const Replay& replay, const std::vector<std::string>& sensors) {
  const std::size_t layers = layersOf(replay, sensors);
  const auto& channels = replay.channels();
  const auto measured = [&](Channel c) { return std::find(channels.begin(), channels.end(), c) != channels.end(); };
  if (layers < 2 || (!measured(kIntensity) && !measured(kEpw))) return {};
  const Channel channel = measured(kIntensity) ? kIntensity : kEpw;
  std::vector<std::size_t> samples = samplesOf(replay, sensors, false);
  if (samples.empty()) samples = samplesOf(replay, sensors, true);

  std::vector<std::vector<double>> ratios(layers);
  for (const std::size_t s : samples) {
    const ReplaySample& sample = replay.samples()[s];
    const model::SensorProfile& profile = replay.baseline().model.sensor(sample.sample->sensor);
    const double pulse_m = core::kMetresPerNanosecond * profile.emitter.pulse_fwhm_ns;
    const auto simulated = replay.simulate(replay.baseline(), s, kFrames, replay.baseline().model.seed);
    for (std::size_t c = 0; c < sample.layout->surfaces(); ++c) {
      const CellStatistics& m = sample.statistics[c];
      if (m.count < 1.0 || simulated[c].count < 1.0) continue;
      const double ratio = logRatio(m, simulated[c], channel, pulse_m);
      const auto layer = static_cast<std::size_t>(sample.beams[sample.layout->cells()[c].beam].layer);
      if (std::isfinite(ratio) && layer < ratios.size()) ratios[layer].push_back(ratio);
    }
  }
  std::vector<double> gains(ratios.size(), NAN);
  for (std::size_t layer = 0; layer < ratios.size(); ++layer) {
    auto& list = ratios[layer];
    if (list.size() < kFewestCells) continue;
    gains[layer] = std::exp(medianOf(list));
  }
  return gains;
}

std::vector<double> unevenPartOf(std::vector<double> gains) {
  std::vector<double> seen;
  for (const double gain : gains) {
    if (std::isfinite(gain)) seen.push_back(std::log(gain));
  }
  if (seen.empty() || (seen.size() > 1 && meanByChance(seen) > kSharedByChance)) return gains;
  const double shared = std::exp(std::accumulate(seen.begin(), seen.end(), 0.0) / static_cast<double>(seen.size()));
  for (double& gain : gains) gain /= shared;
  return gains;
}

}  // namespace gap
