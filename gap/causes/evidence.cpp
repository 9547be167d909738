#include "gap/causes/evidence.h"

#include <algorithm>

#include "gap/distance/settle.h"

namespace gap {

namespace {

/// How many frames are simulated of a sample.
int simulatedFrames(const Evidence& evidence, const ReplaySample& sample) {
  const auto affordable = static_cast<int>(evidence.most_shots / std::max<std::size_t>(1, sample.beams.size()));
  return std::min({evidence.most_frames, std::max(3, sample.frames), std::max(3, affordable)});
}

/// Discrepancy once the simulated surfaces stand where they fit best, with the price of that.
double settled(const Replay& replay, const World& world, std::vector<Comparison> comparisons, Part part) {
  const double price = settle(replay, world, comparisons, part);
  return price + discrepancy(replay, comparisons, part);
}

}  // namespace

Evidence spreadOver(const Evidence& evidence, std::size_t most_samples, int most_frames) {
  Evidence few = evidence;
  few.most_frames = most_frames;
  if (evidence.samples.size() <= most_samples) return few;
  few.samples.clear();
  for (std::size_t i = 0; i < most_samples; ++i) {
    few.samples.push_back(evidence.samples[i * (evidence.samples.size() - 1) / (most_samples - 1)]);
  }
  return few;
}

std::vector<Comparison> comparisonsOf(const Replay& replay, const World& world, const Evidence& evidence) {
  std::vector<Comparison> comparisons;
  for (const std::size_t s : evidence.samples) {
    const ReplaySample& sample = replay.samples()[s];
    const int frames = simulatedFrames(evidence, sample);
    comparisons.push_back(
        {s, sample.statistics, sample.frames, replay.simulate(world, s, frames, evidence.seed), frames});
  }
  return comparisons;
}

std::vector<Comparison> comparisonsTo(const std::vector<Comparison>& other, const Replay& replay, const World& world,
                                      const Evidence& evidence) {
  std::vector<Comparison> comparisons = comparisonsOf(replay, world, evidence);
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    comparisons[i].measured = other[i].simulated;
    comparisons[i].measured_frames = other[i].simulated_frames;
  }
  return comparisons;
}

World worldOf(const Replay& replay, const Hypothesis& hypothesis, const std::vector<double>& values) {
  World world = replay.baseline();
  hypothesis.apply(world, values);
  return world;
}

Measured measuredIn(const Replay& replay, const World& truth, const Evidence& evidence, std::uint64_t seed) {
  std::vector<Comparison> simulated;
  for (const std::size_t s : evidence.samples) {
    const int frames = replay.samples()[s].frames;
    simulated.push_back({s, {}, frames, replay.simulate(truth, s, frames, seed), frames});
  }
  scatter(replay, truth, simulated, seed);
  Measured measured;
  for (Comparison& sample : simulated) measured.push_back(std::move(sample.simulated));
  return measured;
}

SimulatedWorld::SimulatedWorld(const Replay& replay, const World& world, const Evidence& evidence,
                               std::size_t simulations)
    : replay_(replay), world_(world), part_(evidence.part) {
  constexpr std::uint64_t kStep = 10007;  // far from the seeds of what is drawn
  Evidence under = evidence;
  for (std::size_t k = 0; k < simulations; ++k) {
    simulations_.push_back(comparisonsOf(replay, world, under));
    under.seed += kStep;
  }
}

double SimulatedWorld::discrepancy() const {
  double sum = 0.0;
  for (const std::vector<Comparison>& comparisons : simulations_) sum += settled(replay_, world_, comparisons, part_);
  return sum / static_cast<double>(simulations());
}

double SimulatedWorld::discrepancyTo(const Measured& measured, std::size_t simulation) const {
  std::vector<Comparison> comparisons = simulations_[simulation];
  for (std::size_t i = 0; i < comparisons.size(); ++i) comparisons[i].measured = measured[i];
  return settled(replay_, world_, std::move(comparisons), part_);
}

double SimulatedWorld::discrepancyTo(const Measured& measured) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < simulations(); ++k) sum += discrepancyTo(measured, k);
  return sum / static_cast<double>(simulations());
}

double discrepancyOf(const Replay& replay, const World& world, const Evidence& evidence) {
  return settled(replay, world, comparisonsOf(replay, world, evidence), evidence.part);
}

}  // namespace gap
