#include "gap/candidates/separation.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "gap/candidates/significance.h"

namespace gap {

namespace {

constexpr std::size_t kRunsApart = 8;            // measurements drawn from the first of two causes
constexpr std::uint64_t kOtherThanFitted = 977;  // values suit the simulation that they were fitted to
constexpr double kBeyondDoubt = 4.0;             // standard deviations: told apart, whatever the other samples say

/// How much farther from some evidence one candidate is than another.
struct Apart {
  double difference = 0.0;
  double expected = 0.0;  ///< of it, were the first one right
  double variance = 0.0;  ///< of it then
  double alike = 0.0;     ///< so many nats of it say nothing

  /// By how many nats the second is nearer.
  [[nodiscard]] double nearer() const { return std::max(0.0, -difference - alike); }
  [[nodiscard]] double z() const { return difference / std::max(1e-9, std::sqrt(variance)); }
  /// What so many nats are as a z.
  [[nodiscard]] double ofLikelihoods() const { return std::sqrt(2.0 * std::max(0.0, difference)); }
};

/// The variance is that of one simulation, its noise and all: a rare echo that lies luckily tells no causes apart.
Apart apartOn(const Replay& replay, Evidence evidence, const World& best, const World& rival) {
  evidence.seed += kOtherThanFitted;
  constexpr std::size_t kSimulations = Yardstick::kSimulations;
  const SimulatedWorld of_best(replay, best, evidence, kSimulations), of_rival(replay, rival, evidence, kSimulations);
  std::vector<double> differences(kRunsApart);
  core::parallelFor(differences.size(), 1, [&](std::size_t run, std::size_t) {
    const Measured measured = measuredIn(replay, best, evidence, seedOfRun(evidence, run));
    const std::size_t k = run % kSimulations;
    differences[run] = of_rival.discrepancyTo(measured, k) - of_best.discrepancyTo(measured, k);
  });
  const Distribution were_it_right(differences);
  return {.difference = of_rival.discrepancy() - of_best.discrepancy(),
          .expected = were_it_right.mean,
          .variance = were_it_right.stddev * were_it_right.stddev};
}

/// See separationOnAll; no difference where the second is farther by no more than they are alike.
Apart apartOnAll(const Judge& quick, const Judge& exact, const Candidate& best, const Candidate& rival, double alike) {
  Apart all;
  bool differ = false;
  for (const bool held_out : {true, false}) {
    const Replay& replay = held_out ? exact.replay : quick.replay;
    Evidence evidence = held_out ? exact.split.held_out : quick.split.refined;
    evidence.part.edges = exact.split.held_out.part.edges;
    const World a = worldOf(replay, best.hypothesis, best.values), b = worldOf(replay, rival.hypothesis, rival.values);
    const Apart part = apartOn(replay, evidence, a, b);
    const double explained = discrepancyOf(replay, replay.baseline(), evidence) - discrepancyOf(replay, a, evidence);
    differ = differ || part.difference > alike * explained;
    if (held_out && differ && part.z() > kBeyondDoubt) return part;
    all.difference += part.difference;
    all.variance += part.variance;
    all.alike += alike * explained;
  }
  if (!differ) all.difference = std::min(0.0, all.difference);
  return all;
}

}  // namespace

double gainWereItRight(const Judge& judge, const World& null, const World& world) {
  return apartOn(judge.replay, judge.split.held_out, world, null).expected;
}

double separation(const Judge& judge, const Candidate& best, const Candidate& rival) {
  const Replay& replay = judge.replay;
  return apartOn(replay, judge.split.held_out, worldOf(replay, best.hypothesis, best.values),
                 worldOf(replay, rival.hypothesis, rival.values))
      .z();
}

double separationOnAll(const Judge& quick, const Judge& exact, const Candidate& best, const Candidate& rival,
                       double alike) {
  return apartOnAll(quick, exact, best, rival, alike).z();
}

double toldFromOnAll(const Judge& quick, const Judge& exact, const Candidate& best, const Candidate& rival,
                     double alike, double price) {
  const Apart apart = apartOnAll(quick, exact, best, rival, alike);
  const double told = std::max(0.0, std::min(apart.z(), apart.ofLikelihoods()));
  return std::sqrt(told * told + 2.0 * std::max(0.0, price - apart.nearer()));
}

}  // namespace gap
