#include "gap/significance.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "gap/statistics.h"

namespace gap {

namespace {

constexpr std::size_t kRuns = 40;  // of the null: their spread is known to a tenth
constexpr std::size_t kRoughRuns = 8;
constexpr std::size_t kRunsApart = 8;  // of two causes

constexpr std::uint64_t kFirstSeed = 3000;

/// Of the gain of all samples but one (all, if there is no such sample).
double zOfGains(const std::vector<double>& gains, const std::vector<std::vector<double>>& by_chance,
                std::size_t left_out) {
  const auto sum = [&](const std::vector<double>& of_samples) {
    double total = 0.0;
    for (std::size_t s = 0; s < of_samples.size(); ++s) total += s == left_out ? 0.0 : of_samples[s];
    return total;
  };
  std::vector<double> totals;
  for (const auto& run : by_chance) totals.push_back(sum(run));
  return Distribution(totals).z(sum(gains));
}

}  // namespace

Significance significanceOf(const Judge& judge, const Candidate& candidate) {
  const Replay& replay = judge.replay;
  const Evidence& held_out = judge.split.held_out;
  const World& baseline = replay.baseline();
  const World world = worldOf(replay, candidate.hypothesis, candidate.values);
  const std::size_t samples = held_out.samples.size();
  const auto only = [&](std::size_t sample) {
    Evidence one = held_out;
    one.samples = {held_out.samples[sample]};
    return one;
  };
  std::vector<std::vector<double>> by_chance(kRuns);  // gains, of each sample
  std::vector<double> rests(kRuns);
  core::parallelFor(kRuns, 1, [&](std::size_t run, std::size_t) {
    const std::uint64_t seed = held_out.seed + kFirstSeed + run;
    for (std::size_t s = 0; s < samples; ++s)
      by_chance[run].push_back(discrepancyIn(replay, baseline, baseline, only(s), seed) -
                               discrepancyIn(replay, baseline, world, only(s), seed));
    rests[run] = discrepancyIn(replay, world, world, held_out, seed);
  });
  std::vector<double> gains;
  for (std::size_t s = 0; s < samples; ++s)
    gains.push_back(discrepancyOf(replay, baseline, only(s)) - discrepancyOf(replay, world, only(s)));
  const auto best = static_cast<std::size_t>(std::max_element(gains.begin(), gains.end()) - gains.begin());
  const double z = zOfGains(gains, by_chance, samples);
  return {z, upperTail(z, kRuns), Distribution(rests).z(discrepancyOf(replay, world, held_out)),
          samples > 1 ? zOfGains(gains, by_chance, best) : z};
}

std::vector<double> roughImprovements(const Judge& judge, const std::vector<Candidate>& candidates) {
  const Replay& replay = judge.replay;
  const Evidence& held_out = judge.split.held_out;
  const World& baseline = replay.baseline();
  const auto gainTo = [&](const World& world, std::uint64_t seed) {
    return -discrepancyIn(replay, baseline, world, held_out, seed);
  };
  std::vector<double> without(kRoughRuns);
  core::parallelFor(kRoughRuns, 1, [&](std::size_t run, std::size_t) {
    without[run] = gainTo(baseline, held_out.seed + kFirstSeed + run);
  });
  std::vector<double> improvements(candidates.size());
  core::parallelFor(candidates.size(), 1, [&](std::size_t c, std::size_t) {
    const World world = worldOf(replay, candidates[c].hypothesis, candidates[c].values);
    std::vector<double> gains(kRoughRuns);
    for (std::size_t run = 0; run < kRoughRuns; ++run)
      gains[run] = gainTo(world, held_out.seed + kFirstSeed + run) - without[run];
    const double gain = discrepancyOf(replay, baseline, held_out) - discrepancyOf(replay, world, held_out);
    improvements[c] = Distribution(gains).z(gain);
  });
  return improvements;
}

double separation(const Judge& judge, const Candidate& best, const Candidate& rival) {
  const Replay& replay = judge.replay;
  const Evidence& held_out = judge.split.held_out;
  const World a = worldOf(replay, best.hypothesis, best.values), b = worldOf(replay, rival.hypothesis, rival.values);
  std::vector<double> differences(kRunsApart);
  core::parallelFor(differences.size(), 1, [&](std::size_t run, std::size_t) {
    const std::uint64_t seed = held_out.seed + kFirstSeed + run;
    differences[run] = discrepancyIn(replay, a, b, held_out, seed) - discrepancyIn(replay, a, a, held_out, seed);
  });
  const double observed = discrepancyOf(replay, b, held_out) - discrepancyOf(replay, a, held_out);
  return observed / std::max(1e-9, Distribution(differences).stddev);
}

}  // namespace gap
