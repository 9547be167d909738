#include "gap/candidates/ranking.h"

#include <algorithm>
#include <atomic>
#include <functional>
#include <limits>

#include "core/parallel.h"
#include "gap/candidates/scouted_samples.h"
#include "gap/candidates/suggested.h"
#include "gap/causes/starts.h"

namespace gap {

namespace {

constexpr std::size_t kScoutBeams = 180;    // a sample: enough to find about where a reference is
constexpr std::size_t kAlwaysFitted = 16;   // best hypotheses of the coarse search
constexpr std::size_t kFittedOfSmall = 32;  // where the gap is small few samples hardly show any gain
constexpr double kFitShare = 0.5;           // of the best one's gain there: what gained less is not fitted further
constexpr double kWorthMore = 0.05;  // of the discrepancy: what gained less is tried in no further form that takes long

/// Which hypotheses a coarse search leaves in the race: the best ones, and all that are not far behind.
std::vector<bool> stillPromising(const std::vector<Scouted>& scouted, std::size_t always) {
  std::vector<double> gains;
  for (const Scouted& one : scouted) gains.push_back(one.gain);
  std::sort(gains.begin(), gains.end(), std::greater<>());
  const double of_last = gains.size() > always ? gains[always - 1] : -1.0;
  std::vector<bool> promising;
  for (const Scouted& one : scouted) promising.push_back(one.gain >= of_last || one.gain >= kFitShare * gains.front());
  return promising;
}

/// Whether another form of the same cause gained enough to try one that takes long.
bool worthMore(const Hypothesis& costly, const std::vector<Hypothesis>& tried, const std::vector<Scouted>& scouted) {
  for (std::size_t h = 0; h < tried.size(); ++h) {
    const bool same = tried[h].name == costly.name && tried[h].sensors == costly.sensors;
    if (same && scouted[h].gain >= kWorthMore) return true;
  }
  return false;
}

/// The better of two fits: from where the coarse search ended, and from what the residual map suggests. A sector as
/// wide as the view may come as near with few samples, and no small step leads from there to where it ends. What the
/// fitted samples leave open (a gate opens somewhere between two walls), the map, which all samples made, tells.
std::vector<double> fittedOf(const Judge& judge, const Hypothesis& hypothesis, const std::vector<double>& scouted,
                             const WhereResult& where, const core::Progress& progress) {
  const Evidence evidence = judge.splitFor(hypothesis).fitted;
  const auto fit = [&](const std::vector<double>& start) {
    return fitFrom(judge.replay, hypothesis, evidence, start, progress);
  };
  const auto distance = [&](const std::vector<double>& values) { return judge.leftOn(evidence, hypothesis, values); };
  std::vector<double> fitted = fit(scouted);
  const Evidence few = spreadOver(evidence, kScoutedSamples, evidence.most_frames);
  const std::vector<double> suggested =
      nearestStart(judge.replay, hypothesis, few, std::numeric_limits<double>::infinity(), where, progress);
  if (suggested.empty() || suggested == scouted) return fitted;
  std::vector<double> other = fit(suggested);
  if (distance(other) < distance(fitted)) fitted = std::move(other);
  return distance(suggested) < distance(fitted) + Judge::kNatsPerNumber ? suggested : fitted;
}

}  // namespace

std::vector<Candidate> fitted(const Judge& judge, const std::vector<Hypothesis>& hypotheses, const WhereResult& where,
                              core::Progress& progress, const World* known) {
  std::atomic<std::size_t> done = 0;
  const auto report = [&](const char* doing, const Hypothesis& hypothesis) {
    progress.report(static_cast<double>(++done) / static_cast<double>(2 * hypotheses.size()), doing + hypothesis.name);
  };
  // Every offset of a reference traces all rays anew, and the surfaces that it moves are in many beams.
  const Replay few = judge.replay.thinner(kScoutBeams);
  const Evidence scouted_on = scoutedSamples(judge.split.fitted, where);
  const auto scoutAll = [&](const std::vector<Hypothesis>& some) {
    std::vector<Scouted> scouted(some.size());
    core::parallelFor(some.size(), 1, [&](std::size_t h, std::size_t) {
      const Replay& replay = some[h].kind == CauseKind::kReference ? few : judge.replay;
      const Evidence evidence = some[h].per_setup ? judge.splitFor(some[h]).fitted : scouted_on;
      scouted[h] = scout(replay, some[h], evidence, startsFrom(judge.replay, some[h], where), progress, known);
      report("tried ", some[h]);
    });
    return scouted;
  };
  std::vector<Hypothesis> tried, costly;
  for (const Hypothesis& hypothesis : hypotheses) (hypothesis.costly ? costly : tried).push_back(hypothesis);
  std::vector<Scouted> scouted = scoutAll(tried);
  std::erase_if(costly, [&](const Hypothesis& hypothesis) { return !worthMore(hypothesis, tried, scouted); });
  for (Scouted& one : scoutAll(costly)) scouted.push_back(std::move(one));
  tried.insert(tried.end(), costly.begin(), costly.end());

  const std::vector<bool> promising =
      stillPromising(scouted, judge.yardstick.z() < Yardstick::kClear_z ? kFittedOfSmall : kAlwaysFitted);
  std::vector<Candidate> candidates(tried.size());
  core::parallelFor(tried.size(), 1, [&](std::size_t h, std::size_t) {
    Candidate& candidate = candidates[h];
    candidate.hypothesis = tried[h];
    candidate.values = scouted[h].values;
    if (promising[h]) candidate.values = fittedOf(judge, tried[h], scouted[h].values, where, progress);
    report("fitted ", tried[h]);
  });
  return candidates;
}

std::vector<Candidate> rank(const Judge& judge, const std::vector<Hypothesis>& hypotheses, const WhereResult& where,
                            core::Progress& progress) {
  std::vector<Candidate> candidates = fitted(judge, hypotheses, where, progress);
  core::parallelFor(candidates.size(), 1, [&](std::size_t c, std::size_t) {
    core::stopIfCancelled(progress);
    judge.hear(candidates[c]);
  });
  sortByMerit(candidates);
  return candidates;
}

}  // namespace gap
