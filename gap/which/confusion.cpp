#include "gap/which/confusion.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/parallel.h"
#include "gap/distance/discrepancy.h"
#include "gap/where/residual_tables.h"

namespace gap {

namespace {

constexpr int kFrames = 8;
constexpr std::size_t kSamples = 6;
constexpr std::uint64_t kOtherNoise = 4000;  // added to the seed
constexpr double kClear = 3.0;               // standard errors in which predictions of a beam must differ
constexpr double kLeastBeams = 0.02;         // fewer may differ by chance

using Statistics = std::vector<CellStatistics>;

int framesFor(const ReplaySample& sample) { return std::clamp(sample.frames, 3, kFrames); }

/// Every world of one sample, twice under different noise.
struct SimulatedTwice {
  std::vector<Statistics> as_truth;
  std::vector<Statistics> as_model;
};

SimulatedTwice simulateAll(const Replay& replay, const std::vector<const World*>& worlds, std::size_t s,
                           std::uint64_t seed) {
  SimulatedTwice simulated{std::vector<Statistics>(worlds.size()), std::vector<Statistics>(worlds.size())};
  const int frames = framesFor(replay.samples()[s]);
  core::parallelFor(worlds.size(), 1, [&](std::size_t w, std::size_t) {
    simulated.as_truth[w] = replay.simulate(*worlds[w], s, frames, seed + kOtherNoise);
    simulated.as_model[w] = replay.simulate(*worlds[w], s, frames, seed);
  });
  return simulated;
}

/// D of all pairs, [truth][model], summed over the samples.
std::vector<std::vector<double>> distances(const Replay& replay, const std::vector<const World*>& worlds,
                                           const Evidence& evidence) {
  const std::size_t n = worlds.size();
  const std::vector<std::size_t> samples = spreadOver(evidence, kSamples, kFrames).samples;
  std::vector<SimulatedTwice> simulated;
  for (const std::size_t s : samples) simulated.push_back(simulateAll(replay, worlds, s, evidence.seed));
  std::vector<std::vector<double>> sums(n, std::vector<double>(n, 0.0));
  core::parallelFor(n * n, 1, [&](std::size_t at, std::size_t) {
    const std::size_t i = at / n, j = at % n;
    std::vector<Comparison> comparisons;
    for (std::size_t k = 0; k < samples.size(); ++k) {
      const int frames = framesFor(replay.samples()[samples[k]]);
      comparisons.push_back({samples[k], simulated[k].as_truth[i], frames, simulated[k].as_model[j], frames});
    }
    sums[i][j] = discrepancy(replay, comparisons, evidence.part);
  });
  return sums;
}

/// A beam's prediction by two worlds, with the error of their difference.
struct Pair {
  double a = 0.0;
  double b = 0.0;
  double error = 1.0;
};

/// What a world says of a cell: the mean of a channel, or (without a channel) the echoes per shot.
double valueOf(const CellStatistics& cell, std::optional<Channel> channel, int frames) {
  return channel ? cell.mean(*channel) : cell.count / frames;
}

std::optional<Pair> compared(const Replay& replay, const ReplaySample& sample, std::size_t cell,
                             const CellStatistics& a, const CellStatistics& b, std::optional<Channel> channel,
                             int frames) {
  Pair pair{0.0, 0.0, 0.0};
  if (channel) {
    if (a.count < 1.0 || b.count < 1.0) return std::nullopt;
    pair.error = meanError(replay, sample, cell, *channel, a, b);
  } else {
    const double rate = std::clamp(0.5 * (a.count + b.count) / frames, 0.05, 0.95);
    pair.error = std::sqrt(2.0 * rate * (1.0 - rate) / frames);
  }
  pair.a = valueOf(a, channel, frames);
  pair.b = valueOf(b, channel, frames);
  return pair;
}

/// The cells in which the two clearly differ, all in the direction that is commoner.
struct Telling {
  std::vector<std::size_t> cells;
  double noise = 0.0;
};

Telling tellingCells(const Replay& replay, const ReplaySample& sample, const Statistics& a, const Statistics& b,
                     std::optional<Channel> channel, int frames) {
  Telling above, below;
  for (std::size_t c = 0; c < sample.layout->surfaces(); ++c) {
    const auto pair = compared(replay, sample, c, a[c], b[c], channel, frames);
    if (!pair || std::abs(pair->a - pair->b) < kClear * pair->error) continue;
    Telling& side = pair->a > pair->b ? above : below;
    side.cells.push_back(c);
    side.noise += pair->error;
  }
  Telling& more = above.cells.size() >= below.cells.size() ? above : below;
  more.noise /= static_cast<double>(std::max<std::size_t>(1, more.cells.size()));
  return more;
}

double meanOver(const std::vector<std::size_t>& cells, const Statistics& statistics, std::optional<Channel> channel,
                int frames) {
  double sum = 0.0, count = 0.0;
  for (const std::size_t c : cells) {
    if (channel && statistics[c].count < 1.0) continue;
    sum += valueOf(statistics[c], channel, frames);
    count += 1.0;
  }
  return count > 0.0 ? sum / count : NAN;
}

double clarityOf(const Prediction& prediction) {
  const std::size_t n = prediction.values.size();
  return prediction.beams * std::abs(prediction.values[n - 1] - prediction.values[n - 2]) / prediction.noise;
}

}  // namespace

Confusion confusionOf(const Replay& replay, const std::vector<NamedWorld>& causes, const Evidence& evidence) {
  Confusion confusion;
  std::vector<const World*> worlds;
  for (const NamedWorld& cause : causes) {
    confusion.names.push_back(cause.name);
    worlds.push_back(&cause.world);
  }
  worlds.push_back(&replay.baseline());
  const std::size_t n = causes.size();
  if (n == 0) return confusion;
  const auto d = distances(replay, worlds, evidence);
  confusion.alike.assign(n, std::vector<double>(n, 1.0));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double noise = 0.5 * (d[i][i] + d[j][j]);
      const double apart = 0.5 * (d[i][j] + d[j][i]) - noise;
      const double whole = std::max(0.5 * (d[i][n] + d[n][i]), 0.5 * (d[j][n] + d[n][j])) - noise;
      const double alike = whole > 0.0 ? std::clamp(1.0 - apart / whole, 0.0, 1.0) : 1.0;
      confusion.alike[i][j] = confusion.alike[j][i] = alike;
    }
  }
  return confusion;
}

std::vector<Prediction> predictionsOf(const Replay& replay, const std::vector<World>& worlds, std::size_t s,
                                      std::uint64_t seed) {
  const ReplaySample& sample = replay.samples()[s];
  const int frames = framesFor(sample);
  std::vector<Statistics> simulated;
  for (const World& world : worlds) simulated.push_back(replay.simulate(world, s, frames, seed));
  std::vector<std::optional<Channel>> channels(replay.channels().begin(), replay.channels().end());
  if (!sample.layout->pooled()) channels.push_back(std::nullopt);
  std::vector<Prediction> predictions;
  for (const auto& channel : channels) {
    const Telling telling =
        tellingCells(replay, sample, simulated[simulated.size() - 2], simulated.back(), channel, frames);
    const auto all = static_cast<double>(std::max<std::size_t>(1, sample.layout->surfaces()));
    Prediction prediction{channel ? measurandOf(replay, *channel).name : "existence",
                          channel ? measurandOf(replay, *channel).unit : "1/shot",
                          static_cast<double>(telling.cells.size()) / all,
                          {},
                          telling.noise};
    if (prediction.beams < kLeastBeams) continue;
    for (const Statistics& statistics : simulated)
      prediction.values.push_back(meanOver(telling.cells, statistics, channel, frames));
    predictions.push_back(std::move(prediction));
  }
  std::stable_sort(predictions.begin(), predictions.end(),
                   [](const Prediction& a, const Prediction& b) { return clarityOf(a) > clarityOf(b); });
  return predictions;
}

}  // namespace gap
