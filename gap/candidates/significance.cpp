#include "gap/candidates/significance.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/parallel.h"

namespace gap {

namespace {

constexpr std::size_t kRuns = 40;  // of the null: their spread is known to a tenth
constexpr std::size_t kRoughRuns = 8;
constexpr double kByChance = 0.01;     // that any of the causes tried gains so much where it is not at work
constexpr double kNotOneSample = 3.0;  // standard deviations of the gain of a small cause without its best sample

/// Of all parts but one (all, if there is no such part).
double sumOf(const std::vector<double>& of_parts, std::size_t left_out) {
  double total = 0.0;
  for (std::size_t p = 0; p < of_parts.size(); ++p) total += p == left_out ? 0.0 : of_parts[p];
  return total;
}

/// The same of every run by chance.
Distribution byChance(const NullRuns::Gains& gains, std::size_t left_out) {
  std::vector<double> totals;
  for (const auto& run : gains.by_chance) totals.push_back(sumOf(run, left_out));
  return Distribution(totals);
}

std::vector<SimulatedWorld> onParts(const Replay& replay, const World& world, const std::vector<Evidence>& parts) {
  std::vector<SimulatedWorld> simulated;
  for (const Evidence& part : parts) simulated.emplace_back(replay, world, part);
  return simulated;
}

}  // namespace

std::uint64_t seedOfRun(const Evidence& evidence, std::size_t run) {
  constexpr std::uint64_t kFirst = 3000;
  return evidence.seed + kFirst + run;
}

bool nothingElse(const Significance& significance, std::size_t causes) {
  return significance.p_value * static_cast<double>(causes) < kByChance && significance.rest_z < kNoRest;
}

bool provesItself(const Significance& significance, std::size_t causes) {
  return significance.gain > 0.0 && nothingElse(significance, causes) && significance.without_best_z > kNotOneSample;
}

NullRuns::NullRuns(const Replay& replay, World null, std::vector<Evidence> parts, std::size_t runs)
    : replay_(&replay), null_(std::move(null)), parts_(std::move(parts)), drawn_(runs), without_(runs) {
  const std::vector<SimulatedWorld> simulated = onParts(replay, null_, parts_);
  for (const SimulatedWorld& part : simulated) observed_.push_back(part.discrepancy());
  core::parallelFor(runs, 1, [&](std::size_t run, std::size_t) {
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      drawn_[run].push_back(measuredIn(replay, null_, parts_[p], seedOfRun(parts_[p], run)));
      without_[run].push_back(simulated[p].discrepancyTo(drawn_[run].back()));
    }
  });
}

NullRuns::Gains NullRuns::gainsOf(const World& world) const {
  Gains gains{{}, without_};
  const std::vector<SimulatedWorld> simulated = onParts(*replay_, world, parts_);
  core::parallelFor(runs(), 1, [&](std::size_t run, std::size_t) {
    for (std::size_t p = 0; p < parts_.size(); ++p)
      gains.by_chance[run][p] -= simulated[p].discrepancyTo(drawn_[run][p]);
  });
  for (std::size_t p = 0; p < parts_.size(); ++p) gains.observed.push_back(observed_[p] - simulated[p].discrepancy());
  return gains;
}

std::vector<Evidence> bySample(const Evidence& evidence) {
  std::vector<Evidence> parts;
  for (const std::size_t sample : evidence.samples) {
    parts.push_back(evidence);
    parts.back().samples = {sample};
  }
  return parts;
}

NullRuns::Gains joined(NullRuns::Gains gains, const NullRuns::Gains& more) {
  gains.observed.insert(gains.observed.end(), more.observed.begin(), more.observed.end());
  for (std::size_t run = 0; run < gains.by_chance.size(); ++run) {
    std::vector<double>& of_run = gains.by_chance[run];
    of_run.insert(of_run.end(), more.by_chance[run].begin(), more.by_chance[run].end());
  }
  return gains;
}

NullRuns nullRunsOf(const Judge& judge) { return nullRunsOf(judge, judge.replay.baseline()); }

NullRuns nullRunsOf(const Judge& judge, const World& null) {
  return {judge.replay, null, bySample(judge.split.held_out), kRuns};
}

Distribution ownNoiseOf(const Judge& judge, const World& world, std::size_t runs) {
  const Evidence& held_out = judge.split.held_out;
  const SimulatedWorld simulated(judge.replay, world, held_out);
  std::vector<double> distances(runs);
  core::parallelFor(runs, 1, [&](std::size_t run, std::size_t) {
    distances[run] = simulated.discrepancyTo(measuredIn(judge.replay, world, held_out, seedOfRun(held_out, run)));
  });
  return Distribution(distances);
}

double deviationsLeft(const Judge& judge, const World& world, std::size_t runs) {
  return ownNoiseOf(judge, world, runs).z(discrepancyOf(judge.replay, world, judge.split.held_out));
}

double deviationsLeft(const Judge& judge, const Candidate& candidate) {
  return deviationsLeft(judge, worldOf(judge.replay, candidate.hypothesis, candidate.values), kRuns);
}

Significance significanceOf(const NullRuns::Gains& gains, double rest_z) {
  const std::size_t parts = gains.observed.size();
  const auto best =
      static_cast<std::size_t>(std::max_element(gains.observed.begin(), gains.observed.end()) - gains.observed.begin());
  const Distribution of_all = byChance(gains, parts), without_best = byChance(gains, best);
  const double gain = sumOf(gains.observed, parts), z = of_all.z(gain);
  const bool acts_elsewhere = parts > 1 && without_best.stddev > 0.0;
  return {.gain = gain,
          .by_chance = of_all.mean,
          .improvement_z = z,
          .p_value = upperTail(z, gains.by_chance.size()),
          .rest_z = rest_z,
          .without_best_z = acts_elsewhere ? without_best.z(sumOf(gains.observed, best)) : z};
}

Significance significanceOf(const Judge& judge, const Candidate& candidate, const NullRuns& nulls) {
  const World world = worldOf(judge.replay, candidate.hypothesis, candidate.values);
  return significanceOf(nulls.gainsOf(world), deviationsLeft(judge, world, nulls.runs()));
}

std::vector<double> roughImprovements(const Judge& judge, const std::vector<Candidate>& candidates) {
  const NullRuns nulls(judge.replay, judge.replay.baseline(), {judge.split.held_out}, kRoughRuns);
  std::vector<double> improvements;
  for (const Candidate& candidate : candidates) {
    const World world = worldOf(judge.replay, candidate.hypothesis, candidate.values);
    const NullRuns::Gains gains = nulls.gainsOf(world);
    improvements.push_back(byChance(gains, 1).z(gains.observed.front()));
  }
  return improvements;
}

}  // namespace gap
