#include "gap/significance.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/parallel.h"
#include "gap/statistics.h"

namespace gap {

namespace {

constexpr std::size_t kRuns = 40;  // of the null: their spread is known to a tenth
constexpr std::size_t kRoughRuns = 8;
constexpr std::size_t kRunsApart = 8;  // of two causes

constexpr std::uint64_t kFirstSeed = 3000;

/// Of the gain of all parts but one (all, if there is no such part).
double zOf(const NullRuns::Gains& gains, std::size_t left_out) {
  const auto sum = [&](const std::vector<double>& of_parts) {
    double total = 0.0;
    for (std::size_t p = 0; p < of_parts.size(); ++p) total += p == left_out ? 0.0 : of_parts[p];
    return total;
  };
  std::vector<double> totals;
  for (const auto& run : gains.by_chance) totals.push_back(sum(run));
  return Distribution(totals).z(sum(gains.observed));
}

}  // namespace

NullRuns::NullRuns(const Judge& judge, std::vector<Evidence> parts, std::size_t runs)
    : judge_(&judge), parts_(std::move(parts)), without_(runs) {
  const World& baseline = judge.replay.baseline();
  core::parallelFor(runs, 1, [&](std::size_t run, std::size_t) {
    for (const Evidence& part : parts_)
      without_[run].push_back(discrepancyIn(judge.replay, baseline, baseline, part, seedOf(run)));
  });
}

std::uint64_t NullRuns::seedOf(std::size_t run) const { return judge_->split.held_out.seed + kFirstSeed + run; }

NullRuns::Gains NullRuns::gainsOf(const World& world) const {
  const Replay& replay = judge_->replay;
  const World& baseline = replay.baseline();
  Gains gains{{}, without_};
  core::parallelFor(runs(), 1, [&](std::size_t run, std::size_t) {
    for (std::size_t p = 0; p < parts_.size(); ++p)
      gains.by_chance[run][p] -= discrepancyIn(replay, baseline, world, parts_[p], seedOf(run));
  });
  for (const Evidence& part : parts_)
    gains.observed.push_back(discrepancyOf(replay, baseline, part) - discrepancyOf(replay, world, part));
  return gains;
}

NullRuns nullRunsOf(const Judge& judge) {
  std::vector<Evidence> samples;
  for (const std::size_t sample : judge.split.held_out.samples) {
    samples.push_back(judge.split.held_out);
    samples.back().samples = {sample};
  }
  return {judge, std::move(samples), kRuns};
}

Significance significanceOf(const Judge& judge, const NullRuns& nulls, const Candidate& candidate) {
  const Replay& replay = judge.replay;
  const Evidence& held_out = judge.split.held_out;
  const World world = worldOf(replay, candidate.hypothesis, candidate.values);
  const NullRuns::Gains gains = nulls.gainsOf(world);
  std::vector<double> rests(nulls.runs());
  core::parallelFor(rests.size(), 1, [&](std::size_t run, std::size_t) {
    rests[run] = discrepancyIn(replay, world, world, held_out, nulls.seedOf(run));
  });
  const std::size_t samples = gains.observed.size();
  const auto best =
      static_cast<std::size_t>(std::max_element(gains.observed.begin(), gains.observed.end()) - gains.observed.begin());
  const double z = zOf(gains, samples);
  return {z, upperTail(z, nulls.runs()), Distribution(rests).z(discrepancyOf(replay, world, held_out)),
          samples > 1 ? zOf(gains, best) : z};
}

std::vector<double> roughImprovements(const Judge& judge, const std::vector<Candidate>& candidates) {
  const NullRuns nulls(judge, {judge.split.held_out}, kRoughRuns);
  std::vector<double> improvements;
  for (const Candidate& candidate : candidates) {
    const World world = worldOf(judge.replay, candidate.hypothesis, candidate.values);
    improvements.push_back(zOf(nulls.gainsOf(world), 1));
  }
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
