#include "gap/which/candidates.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "core/parallel.h"
#include "gap/causes/starts.h"
#include "gap/far/how_far.h"
#include "gap/replay/statistics.h"
#include "gap/which/scouted_samples.h"
#include "gap/which/valleys.h"

namespace gap {

namespace {

constexpr int kNullRuns = 20;              // their spread is known to a sixth
constexpr double kPricePerNumber = 0.004;  // of the explained share, at least
constexpr double kMostLeft = 2.0;     // of the total gap: a cause that doubles it is as wrong as one that triples it
constexpr std::size_t kPolished = 3;  // of the leaders fitted with more frames, and
constexpr std::size_t kPolishedPairs = 2;
constexpr std::size_t kScoutBeams = 180;    // a sample: enough to find about where a reference is
constexpr std::size_t kAlwaysFitted = 16;   // best hypotheses of the coarse search
constexpr std::size_t kFittedOfSmall = 32;  // where the gap is small few samples hardly show any gain
constexpr double kFitShare = 0.5;           // of the best one's gain there: what gained less is not fitted further
constexpr double kWorthMore = 0.05;  // of the discrepancy: what gained less is tried in no further form that takes long
constexpr double kNearlyAsGood = 0.3;  // in merit: farther behind no refinement helps

/// Offsets of set-ups cannot be carried over to other set-ups: half of every set-up's beams fit, also of those that are
/// held out; all of these judge, and the price of every number makes up for what it gains on beams that it was fitted
/// to.
Split splitFor(const Judge& judge, const Hypothesis& hypothesis) {
  return hypothesis.per_setup ? splitByBeams(judge.replay, judge.split.fitted.seed) : judge.split;
}

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

/// Of the starts that the residual map suggests the nearest one, if it is nearer than that; else empty.
std::vector<double> nearestStart(const Replay& replay, const Hypothesis& hypothesis, const Evidence& few, double least,
                                 const WhereResult& where, const core::Progress& progress) {
  std::vector<double> nearest;
  for (auto& start : startsFrom(replay, hypothesis, where)) {
    core::stopIfCancelled(progress);
    const double distance = discrepancyOf(replay, worldOf(replay, hypothesis, start), few);
    if (distance >= least) continue;
    least = distance;
    nearest = std::move(start);
  }
  return nearest;
}

/// The better of two fits: from where the coarse search ended, and from what the residual map suggests. A sector as
/// wide as the view may come as near with few samples, and no small step leads from there to where it ends. What the
/// fitted samples leave open (a gate opens somewhere between two walls), the map, which all samples made, tells.
std::vector<double> fittedOf(const Judge& judge, const Hypothesis& hypothesis, const std::vector<double>& scouted,
                             const WhereResult& where, const core::Progress& progress) {
  const Evidence evidence = splitFor(judge, hypothesis).fitted;
  const auto fit = [&](const std::vector<double>& start) {
    return fitFrom(judge.replay, hypothesis, evidence, start, progress);
  };
  const auto distance = [&](const std::vector<double>& values) {
    return discrepancyOf(judge.replay, worldOf(judge.replay, hypothesis, values), evidence);
  };
  std::vector<double> fitted = fit(scouted);
  const Evidence few = spreadOver(evidence, kScoutedSamples, evidence.most_frames);
  const std::vector<double> suggested =
      nearestStart(judge.replay, hypothesis, few, std::numeric_limits<double>::infinity(), where, progress);
  if (suggested.empty() || suggested == scouted) return fitted;
  std::vector<double> other = fit(suggested);
  if (distance(other) < distance(fitted)) fitted = std::move(other);
  return distance(suggested) < distance(fitted) + Judge::kNatsPerNumber ? suggested : fitted;
}

/// The values with every number that does less than it costs put where it does nothing: an effect of several mechanisms
/// says no more than it must.
std::vector<double> simplest(const Judge& judge, const Hypothesis& hypothesis, std::vector<double> values) {
  if (values.size() < 2) return values;
  const auto distance = [&](const std::vector<double>& at) {
    return discrepancyOf(judge.replay, worldOf(judge.replay, hypothesis, at), judge.split.refined);
  };
  double known = distance(values);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const FreeParameter& p = hypothesis.parameters[i];
    if (p.logarithmic || values[i] == p.absent_at || p.absent_at < p.low || p.absent_at > p.high) continue;
    std::vector<double> without = values;
    without[i] = p.absent_at;
    const double left = distance(without);
    if (left > known + Judge::kNatsPerNumber) continue;
    values = std::move(without);
    known = left;
  }
  return values;
}

/// Rare echoes show in all beams only, and a few drawn ones more or less lead a search astray: where the map, which saw
/// all beams, suggests one place (the rate that was counted) and that leaves less of all that is fitted, it is taken.
std::vector<double> orAsCounted(const Judge& exact, const Hypothesis& hypothesis, std::vector<double> values,
                                const WhereResult& where) {
  auto starts = startsFrom(exact.replay, hypothesis, where);
  if (starts.size() != 1 || starts.front() == values) return values;
  const double known = exact.leftOfFitted(hypothesis, values);
  const bool nearer = exact.leftOfFitted(hypothesis, starts.front()) < known - Judge::kNatsPerNumber;
  return nearer ? std::move(starts.front()) : values;
}

/// The best of three searches: around the values that few beams led to, around what the residual map suggests (a sector
/// may have ended between two of the few), and in the valley that two numbers make. `may_lead`: it is not far behind.
std::vector<double> refinedOf(const Judge& judge, const Candidate& candidate, const WhereResult& where,
                              const Valleys* valleys, bool may_lead, const core::Progress& progress) {
  const auto refineBy = may_lead ? refine : refineBriefly;
  const Evidence evidence = splitFor(judge, candidate.hypothesis).refined;
  const auto distance = [&](const std::vector<double>& values, const Evidence& on) {
    return discrepancyOf(judge.replay, worldOf(judge.replay, candidate.hypothesis, values), on);
  };
  std::vector<double> refined = refineBy(judge.replay, candidate.hypothesis, evidence, candidate.values, progress);
  if (!candidate.hypothesis.members.empty() || candidate.hypothesis.per_setup) return refined;
  const auto refineFrom = [&](const std::vector<double>& start) {
    std::vector<double> other = refineBy(judge.replay, candidate.hypothesis, evidence, start, progress);
    if (distance(other, evidence) < distance(refined, evidence)) refined = std::move(other);
  };
  if (valleys != nullptr) {
    const std::vector<double> lowest = valleys->lowestFrom({candidate.hypothesis, refined}, progress);
    if (distance(lowest, evidence) < distance(refined, evidence) - Judge::kNatsPerNumber) refineFrom(lowest);
  }
  const Evidence few = spreadOver(judge.split.fitted, kScoutedSamples, judge.split.fitted.most_frames);
  const std::vector<double> suggested =
      nearestStart(judge.replay, candidate.hypothesis, few, distance(candidate.values, few), where, progress);
  if (!suggested.empty()) refineFrom(suggested);
  refined = orAsCounted(judge, candidate.hypothesis, std::move(refined), where);
  return simplest(judge, candidate.hypothesis, std::move(refined));
}

}  // namespace

void Judge::hear(Candidate& candidate) const {
  const World world = worldOf(replay, candidate.hypothesis, candidate.values);
  const SimulatedWorld simulated(replay, world, split.held_out);
  const double self = simulated.discrepancyTo(measuredIn(replay, world, split.held_out, split.held_out.seed + 2000));
  candidate.discrepancy = simulated.discrepancy();
  candidate.explained = yardstick.explained(candidate.discrepancy, self);
  candidate.merit = meritOf(candidate);
}

double Judge::leftOfFitted(const Hypothesis& hypothesis, const std::vector<double>& values) const {
  return discrepancyOf(replay, worldOf(replay, hypothesis, values), split.fitted);
}

double Judge::meritOf(const Candidate& candidate) const {
  const double as_it_is = (yardstick.baseline - candidate.discrepancy) / yardstick.whole();
  const double price = std::max(kPricePerNumber, kNatsPerNumber / yardstick.whole());
  return 0.5 * (candidate.explained + as_it_is) - price * static_cast<double>(candidate.hypothesis.parameters.size()) -
         weight_of_total * std::min(kMostLeft, candidate.total_left);
}

double Judge::accountedFor(const Candidate& candidate) const {
  const double of_total = 1.0 - std::clamp(candidate.total_left, 0.0, 1.0);
  return (1.0 - weight_of_total) * std::min(1.0, candidate.explained) + weight_of_total * of_total;
}

void sortByMerit(std::vector<Candidate>& candidates) { std::stable_sort(candidates.begin(), candidates.end(), better); }

const Candidate& nearestToFitted(const Judge& judge, std::span<const Candidate> candidates) {
  std::vector<double> left(candidates.size());
  core::parallelFor(left.size(), 1, [&](std::size_t i, std::size_t) {
    left[i] = judge.leftOfFitted(candidates[i].hypothesis, candidates[i].values);
  });
  return candidates[static_cast<std::size_t>(std::min_element(left.begin(), left.end()) - left.begin())];
}

std::size_t placeOfForm(const std::vector<Candidate>& candidates, const Candidate& other) {
  const auto same = std::find_if(candidates.begin(), candidates.end(), [&](const Candidate& one) {
    return formOf(one.hypothesis) == formOf(other.hypothesis);
  });
  return static_cast<std::size_t>(same - candidates.begin());
}

void takeBetter(std::vector<Candidate> improved, std::vector<Candidate>& candidates) {
  for (Candidate& candidate : improved) {
    Candidate& known = candidates[placeOfForm(candidates, candidate)];
    if (better(candidate, known)) known = std::move(candidate);
  }
  sortByMerit(candidates);
}

std::vector<Candidate> membersOf(const Candidate& candidate) {
  if (candidate.hypothesis.members.empty()) return {candidate};
  std::vector<Candidate> members;
  auto values = candidate.values.begin();
  for (const Hypothesis& hypothesis : candidate.hypothesis.members) {
    const auto end = values + static_cast<std::ptrdiff_t>(hypothesis.parameters.size());
    members.push_back({hypothesis, {values, end}, candidate.explained, candidate.discrepancy});
    values = end;
  }
  return members;
}

double Yardstick::whole() const { return std::max({1e-9, perfect_spread, baseline - perfect}); }

double Yardstick::explained(double discrepancy, double self) const {
  // A world may not buy its share with noise: at least half of the way to a quiet right model counts as the whole way.
  const double whole_way = std::max(baseline - std::max(self, perfect), 0.5 * whole());
  return (baseline - discrepancy) / whole_way;
}

double Yardstick::noiseOfShare() const { return std::sqrt(2.0) * perfect_spread / whole(); }

double Yardstick::z() const { return (baseline - perfect) / std::max(1e-9, perfect_spread); }

double Yardstick::p_value() const { return upperTail(z(), kNullRuns); }

Yardstick yardstickOf(const Replay& replay, const Evidence& held_out) {
  Yardstick yardstick;
  const World& world = replay.baseline();
  const SimulatedWorld simulated(replay, world, held_out);
  yardstick.baseline = simulated.discrepancy();
  std::vector<double> runs(kNullRuns);
  core::parallelFor(kNullRuns, 1, [&](std::size_t begin, std::size_t) {
    runs[begin] = simulated.discrepancyTo(measuredIn(replay, world, held_out, held_out.seed + 1000 + begin));
  });
  const Distribution perfect(runs);
  yardstick.perfect = perfect.mean;
  yardstick.perfect_spread = perfect.stddev;
  return yardstick;
}

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
      const Evidence evidence = some[h].per_setup ? splitFor(judge, some[h]).fitted : scouted_on;
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

void takeWhatIsCounted(const Judge& exact, const WhereResult& where, std::vector<Candidate>& candidates,
                       const core::Progress& progress) {
  core::parallelFor(candidates.size(), 1, [&](std::size_t c, std::size_t) {
    Candidate& candidate = candidates[c];
    core::stopIfCancelled(progress);
    std::vector<double> counted = orAsCounted(exact, candidate.hypothesis, candidate.values, where);
    if (counted == candidate.values) return;
    candidate.values = std::move(counted);
    exact.hear(candidate);
  });
  sortByMerit(candidates);
}

void polish(const Judge& judge, const HeldOutGaps& gaps, std::vector<Candidate>& candidates, const WhereResult& where,
            const core::Progress& progress) {
  if (candidates.empty()) return;
  const std::size_t most = std::min(kLeaders, candidates.size());
  std::size_t leaders = 0;
  const auto leads = [&](std::size_t c) {
    return c < most && candidates[c].merit >= candidates.front().merit - kNearlyAsGood;
  };
  std::optional<Valleys> valleys;
  const auto lookAt = [&](std::size_t from, std::size_t to, bool refined) {
    const double best = candidates.front().merit;
    core::parallelFor(to - from, 1, [&](std::size_t c, std::size_t) {
      Candidate& candidate = candidates[from + c];
      const bool may_lead = candidate.merit >= best - kMayLead;
      if (refined)
        candidate.values = refinedOf(judge, candidate, where, valleys ? &*valleys : nullptr, may_lead, progress);
      candidate.total_left = gaps.leftIn(worldOf(judge.replay, candidate.hypothesis, candidate.values));
      judge.hear(candidate);
    });
    std::stable_sort(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(leaders), better);
  };
  // All beams may say less of the first ones than few beams did: then others are as good.
  while (leads(leaders)) {
    const std::size_t looked_at = leaders;
    while (leads(leaders)) ++leaders;
    lookAt(looked_at, leaders, false);
  }
  const bool pairs = !candidates.front().hypothesis.members.empty();
  std::size_t refined = std::min(leaders, pairs ? kPolishedPairs : kPolished);
  while (!pairs && refined < leaders && candidates[refined].merit >= candidates.front().merit - kMayLead) ++refined;
  const auto end = candidates.begin() + static_cast<std::ptrdiff_t>(refined);
  if (!pairs && std::any_of(candidates.begin(), end, Valleys::mayHelp)) valleys.emplace(judge);
  lookAt(0, refined, true);
  // What was not looked at closely is no better than what was.
  const double of_last = candidates[leaders - 1].merit;
  for (std::size_t c = leaders; c < candidates.size(); ++c)
    candidates[c].merit = std::min(candidates[c].merit, of_last);
}

}  // namespace gap
