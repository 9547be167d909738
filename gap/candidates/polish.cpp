#include "gap/candidates/polish.h"

#include <algorithm>
#include <optional>
#include <span>

#include "core/parallel.h"
#include "gap/candidates/scouted_samples.h"
#include "gap/candidates/suggested.h"
#include "gap/candidates/valleys.h"
#include "gap/candidates/whole_gap.h"

namespace gap {

namespace {

constexpr std::size_t kPolished = 3;  // of the leaders fitted with more frames, and
constexpr std::size_t kPolishedPairs = 2;
constexpr double kNearlyAsGood = 0.3;  // in merit: farther behind no refinement helps

/// The values with every number that does less than it costs put where it does nothing: an effect of several mechanisms
/// says no more than it must.
std::vector<double> simplest(const Judge& judge, const Hypothesis& hypothesis, std::vector<double> values) {
  if (values.size() < 2) return values;
  const auto distance = [&](const std::vector<double>& at) {
    return judge.leftOn(judge.split.refined, hypothesis, at);
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

/// The best of three searches: around the values that few beams led to, around what the residual map suggests (a sector
/// may have ended between two of the few), and in the valley that two numbers make. `may_lead`: it is not far behind.
std::vector<double> refinedOf(const Judge& judge, const Candidate& candidate, const WhereResult& where,
                              const Valleys* valleys, bool may_lead, const core::Progress& progress) {
  const auto refineBy = may_lead ? refine : refineBriefly;
  const Evidence evidence = judge.splitFor(candidate.hypothesis).refined;
  const auto distance = [&](const std::vector<double>& values, const Evidence& on) {
    return judge.leftOn(on, candidate.hypothesis, values);
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

/// Who looks at candidates with all beams.
struct Polisher {
  const Judge& judge;
  const HeldOutGaps& gaps;
  const WhereResult& where;
  const core::Progress& progress;

  [[nodiscard]] std::size_t hearLeaders(std::vector<Candidate>& candidates) const;
  void refineFirst(std::span<Candidate> leaders) const;
  void takeBackWhatIsOpen(const Candidate& before, Candidate& refined) const;
};

/// How many leaders there are, once all beams judge them, best first: they may say less of the first ones than few
/// beams did, and then others are as good.
std::size_t Polisher::hearLeaders(std::vector<Candidate>& candidates) const {
  const std::size_t most = std::min(kLeaders, candidates.size());
  const auto leads = [&](std::size_t c) {
    return c < most && candidates[c].merit >= candidates.front().merit - kNearlyAsGood;
  };
  std::size_t leaders = 0;
  while (leads(leaders)) {
    const std::size_t heard = leaders;
    while (leads(leaders)) ++leaders;
    core::parallelFor(leaders - heard, 1,
                      [&](std::size_t c, std::size_t) { hearOnTotal(judge, gaps, candidates[heard + c]); });
    std::stable_sort(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(leaders), better);
  }
  return leaders;
}

/// Puts numbers back where they were that the fitted samples leave open, to less than a number costs, if held-out ones
/// like that better by as much: a gate that only a held-out wall shows goes anywhere while another number is refined.
void Polisher::takeBackWhatIsOpen(const Candidate& before, Candidate& refined) const {
  const Evidence evidence = judge.splitFor(refined.hypothesis).refined;
  const auto distance = [&](const std::vector<double>& values) {
    return judge.leftOn(evidence, refined.hypothesis, values);
  };
  const double most = distance(refined.values) + Judge::kNatsPerNumber;
  for (std::size_t i = 0; i < refined.values.size(); ++i) {
    Candidate back = refined;
    back.values[i] = before.values[i];
    if (back.values == refined.values || distance(back.values) > most) continue;
    hearOnTotal(judge, gaps, back);
    const bool nearer = back.discrepancy < refined.discrepancy - Judge::kNatsPerNumber;
    if (nearer && better(back, refined)) refined = std::move(back);
  }
}

/// Better values of the first leaders, and all in order again.
void Polisher::refineFirst(std::span<Candidate> leaders) const {
  const bool pairs = !leaders.front().hypothesis.members.empty();
  const double best = leaders.front().merit;
  const auto mayLead = [&](const Candidate& candidate) { return candidate.merit >= best - kMayLead; };
  std::size_t refined = std::min(leaders.size(), pairs ? kPolishedPairs : kPolished);
  while (!pairs && refined < leaders.size() && mayLead(leaders[refined])) ++refined;
  const std::span<Candidate> first = leaders.first(refined);
  std::optional<Valleys> valleys;
  if (!pairs && std::any_of(first.begin(), first.end(), Valleys::mayHelp)) valleys.emplace(judge);
  core::parallelFor(first.size(), 1, [&](std::size_t c, std::size_t) {
    Candidate& candidate = first[c];
    const Candidate before = candidate;
    candidate.values = refinedOf(judge, candidate, where, valleys ? &*valleys : nullptr, mayLead(candidate), progress);
    hearOnTotal(judge, gaps, candidate);
    if (better(before, candidate) && !candidate.hypothesis.per_setup) takeBackWhatIsOpen(before, candidate);
  });
  std::stable_sort(leaders.begin(), leaders.end(), better);
}

}  // namespace

void polish(const Judge& judge, const HeldOutGaps& gaps, std::vector<Candidate>& candidates, const WhereResult& where,
            const core::Progress& progress) {
  if (candidates.empty()) return;
  const Polisher polisher{judge, gaps, where, progress};
  const std::size_t leaders = polisher.hearLeaders(candidates);
  polisher.refineFirst(std::span(candidates).first(leaders));
  // What was not looked at closely is no better than what was.
  const double of_last = candidates[leaders - 1].merit;
  for (std::size_t c = leaders; c < candidates.size(); ++c)
    candidates[c].merit = std::min(candidates[c].merit, of_last);
}

}  // namespace gap
