#include "gap/significance.h"

#include <cmath>

#include "core/parallel.h"
#include "gap/statistics.h"

namespace gap {

namespace {

constexpr std::size_t kRuns = 16;
constexpr std::uint64_t kFirstSeed = 3000;

}  // namespace

Significance significanceOf(const Judge& judge, const Candidate& candidate) {
  const Replay& replay = judge.replay;
  const Evidence& held_out = judge.split.held_out;
  const World& baseline = replay.baseline();
  const World world = worldOf(replay, candidate.hypothesis, candidate.values);
  std::vector<double> gains(kRuns), rests(kRuns);
  core::parallelFor(kRuns, 1, [&](std::size_t run, std::size_t) {
    const std::uint64_t seed = held_out.seed + kFirstSeed + run;
    gains[run] = discrepancyIn(replay, baseline, baseline, held_out, seed) -
                 discrepancyIn(replay, baseline, world, held_out, seed);
    rests[run] = discrepancyIn(replay, world, world, held_out, seed);
  });
  double before = 0.0, after = 0.0, better = 0.0;
  for (const std::size_t s : held_out.samples) {
    Evidence one = held_out;
    one.samples = {s};
    const double of_baseline = discrepancyOf(replay, baseline, one), of_world = discrepancyOf(replay, world, one);
    before += of_baseline;
    after += of_world;
    if (of_world < of_baseline) better += 1.0 / static_cast<double>(held_out.samples.size());
  }
  const double improvement_z = Distribution(gains).z(before - after);
  return {improvement_z, upperTail(improvement_z, kRuns), Distribution(rests).z(after), better};
}

double separation(const Judge& judge, const Candidate& best, const Candidate& rival) {
  const Replay& replay = judge.replay;
  const Evidence& held_out = judge.split.held_out;
  const World a = worldOf(replay, best.hypothesis, best.values), b = worldOf(replay, rival.hypothesis, rival.values);
  std::vector<double> differences(kRuns / 2);
  core::parallelFor(differences.size(), 1, [&](std::size_t run, std::size_t) {
    const std::uint64_t seed = held_out.seed + kFirstSeed + run;
    differences[run] = discrepancyIn(replay, a, b, held_out, seed) - discrepancyIn(replay, a, a, held_out, seed);
  });
  const double observed = discrepancyOf(replay, b, held_out) - discrepancyOf(replay, a, held_out);
  return observed / std::max(1e-9, Distribution(differences).stddev);
}

}  // namespace gap
