#include "gap/which/decision.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>

#include "core/progress.h"
#include "gap/candidates/closer_look.h"
#include "gap/candidates/cross_fit.h"
#include "gap/candidates/enough.h"
#include "gap/candidates/polish.h"
#include "gap/candidates/ranking.h"
#include "gap/candidates/significance.h"
#include "gap/candidates/suggested.h"
#include "gap/candidates/whole_gap.h"
#include "gap/pairs/same_sector.h"
#include "gap/unexplained/rest.h"
#include "gap/which/counter.h"
#include "gap/which/naming_pairs.h"
#include "gap/which/twins.h"

namespace gap {

namespace {

constexpr double kLeastShrink = 0.05;  // of the total gap: less may be luck, or how edges cut beams
constexpr std::size_t kLookedAt = 8;   // of best merit, and as many that gain most: they may prove themselves
constexpr double kWorthALook = 1.0;    // standard deviations of the gain with few beams: with all it takes four of them
constexpr double kWorthCrossing = 1.5;  // standard deviations of the gain, to look at the other samples as well

VerdictKind kindOf(CauseKind kind) {
  switch (kind) {
    case CauseKind::kEffect:
      return VerdictKind::kEffect;
    case CauseKind::kParameter:
      return VerdictKind::kParameter;
    case CauseKind::kReference:
      return VerdictKind::kReference;
  }
  return VerdictKind::kUnknown;
}

/// All causes alone, best first. A reference that turns out to stand within what is recorded of it is none.
std::vector<Candidate> rankedAlone(const Judge& quick, const Judge& exact, const HeldOutGaps& gaps,
                                   const WhereResult& where, const std::vector<Hypothesis>& hypotheses,
                                   core::Progress& progress) {
  core::PartOfProgress part(progress, 0.1, 0.5);
  std::vector<Candidate> singles = rank(quick, hypotheses, where, part);
  const auto withoutErrors = [&] {
    return std::erase_if(singles, [&](const Candidate& candidate) {
      return asRecorded(exact.replay, candidate.hypothesis, candidate.values);
    });
  };
  withoutErrors();
  takeWhatIsCounted(exact, where, singles, progress);
  polish(exact, gaps, singles, where, progress);
  takeValuesOfTwins(quick, exact, singles, progress);
  if (withoutErrors() > 0) polish(exact, gaps, singles, where, progress);  // better values may be within what is known
  return singles;
}

/// The best causes, those that gain most above what they make of noise (some make more of it than others), and those
/// that the values show by themselves.
std::vector<Candidate> worthALook(const Judge& quick, const std::vector<Candidate>& singles) {
  const std::vector<double> improvements = roughImprovements(quick, singles);
  std::vector<double> sorted = improvements;
  std::sort(sorted.begin(), sorted.end(), std::greater<>());
  const double least = sorted[std::min(kLookedAt, sorted.size()) - 1];
  std::vector<Candidate> chosen;
  for (std::size_t i = 0; i < singles.size(); ++i) {
    const bool leads = i < kLookedAt || improvements[i] >= least;
    if ((leads && improvements[i] > kWorthALook) || singles[i].hypothesis.seen_in_values) chosen.push_back(singles[i]);
  }
  return chosen;
}

/// Looks at causes one after the other, at the other samples as well where it may be worth it.
class Proofs {
 public:
  Proofs(const Judge& quick, const Judge& exact) : quick_(quick), exact_(exact), nulls_(nullRunsOf(exact)) {}

  [[nodiscard]] Significance of(const Candidate& candidate, const core::Progress& progress) {
    const Hypothesis& hypothesis = candidate.hypothesis;
    const World world = worldOf(exact_.replay, hypothesis, candidate.values);
    const NullRuns::Gains gains = nulls_.gainsOf(world);
    const Significance held_out = significanceOf(gains, deviationsLeft(exact_, world, nulls_.runs()));
    if (held_out.improvement_z <= kWorthCrossing || !CrossFit::applies(exact_, hypothesis)) return held_out;
    if (!others_) others_.emplace(quick_, exact_, nulls_.runs());
    return significanceOf(joined(gains, others_->gainsOf(hypothesis, progress)), held_out.rest_z);
  }

 private:
  const Judge& quick_;
  const Judge& exact_;
  NullRuns nulls_;
  std::optional<CrossFit> others_;  ///< the samples that were fitted, where any cause needs them
};

/// Where no gap shows before any cause is tried, the best of the causes whose own gain shows that there is one.
void nameWhatProvesItself(const Judge& quick, const Judge& exact, const HeldOutGaps& gaps, const WhereResult& where,
                          Decision& decision, const core::Progress& progress) {
  decision.kind = VerdictKind::kNone;
  std::vector<Candidate> proven, others;
  std::map<Form, double> p_values;
  const auto matters = [&](const Candidate& candidate) {
    const World world = worldOf(exact.replay, candidate.hypothesis, candidate.values);
    const auto shrinks = [&] { return gaps.shrinkTo(gaps.totalIn(world)) > kLeastShrink; };
    if (candidate.hypothesis.seen_in_values) return shrinks();
    if (candidate.explained <= 0.0) return false;  // other samples than those held out may gain
    return shrinks() || (!exact.replay.movesRays(world) && gaps.with(world, progress).shrink.interval.low > 0.0);
  };
  Proofs proofs(quick, exact);
  for (Candidate& candidate : worthALook(quick, decision.singles)) {
    core::stopIfCancelled(progress);
    const Significance significance = proofs.of(candidate, progress);
    const bool shown = candidate.hypothesis.seen_in_values || provesItself(significance, decision.singles.size());
    exact.hear(candidate);
    if (!shown || !matters(candidate)) {
      others.push_back(std::move(candidate));
      continue;
    }
    p_values[formOf(candidate.hypothesis)] = significance.p_value;
    proven.push_back(std::move(candidate));
  }
  sortByMerit(proven);
  polish(exact, gaps, proven, where, progress);
  std::erase_if(proven, [&](const Candidate& candidate) { return !matters(candidate); });  // better values, less gain
  if (proven.empty()) return;
  const double p_value = p_values.at(formOf(proven.front().hypothesis));
  decision.p_value = std::min(1.0, p_value * static_cast<double>(decision.singles.size()));
  decision.name(proven.front());
  // What did not prove itself may still come as near: it only has more to pay, or its own share of luck.
  sortByMerit(others);
  proven.insert(proven.end(), std::make_move_iterator(others.begin()), std::make_move_iterator(others.end()));
  decision.rivals = rivalsOfAll(quick, exact, proven);
  std::erase_if(decision.singles, [&](const Candidate& single) { return placeOfForm(proven, single) < proven.size(); });
  decision.singles.insert(decision.singles.begin(), std::make_move_iterator(proven.begin()),
                          std::make_move_iterator(proven.end()));
}

/// Names the best single cause if it accounts for enough, or if nothing else is left; a counter that the values show in
/// any case, and what earns its place beside it.
void nameTheBest(const Judge& quick, const Judge& exact, const HeldOutGaps& gaps, const WhereResult& where,
                 Decision& decision, core::Progress& progress) {
  leadByAll(quick, exact, decision.singles);
  leadByPlainest(quick, exact, decision.singles);
  leadOnTotal(exact, gaps, enoughToName(exact.yardstick), decision.singles, progress);
  const Candidate& best = decision.singles.front();
  const bool shown = best.explained > exact.yardstick.noiseOfShare();  // by its cells, beside the pooled gap
  const bool explains = best.hypothesis.seen_in_values || best.explained >= kNearlyAllCells ||
                        (shown && exact.accountedFor(best) >= enoughToName(exact.yardstick)) ||
                        (best.explained >= kWeakGap &&
                         nothingElse(significanceOf(exact, best, nullRunsOf(exact)), decision.singles.size()));
  const bool counted = showACounter(decision.singles);
  if (!explains && !counted) return;
  if (counted) {
    auto pairs = besideTheCounter(quick, exact, gaps, where, decision.singles, progress);
    if (!pairs.empty() && earnsBesideTheCounter(exact, decision.singles, pairs.front())) {
      nameFirstOf(pairs, quick, exact, decision);
      decision.pairs.insert(decision.pairs.begin(), pairs.begin(), pairs.end());
      return;
    }
    if (!pairs.empty() || !explains) leadByTheCounter(decision.singles);
  }
  decision.name(decision.singles.front());
  decision.rivals = rivalsOf(quick, exact, decision.singles);
}

/// The most that the winner explains together with any second cause that was tried.
double explainedBesideAny(const Decision& decision) {
  double most = decision.winner->explained;
  for (const Candidate& pair : decision.pairs) {
    const std::vector<Candidate> members = membersOf(pair);
    if (placeOfForm(members, *decision.winner) < members.size()) most = std::max(most, pair.explained);
  }
  return most;
}

}  // namespace

std::string toString(VerdictKind kind) {
  switch (kind) {
    case VerdictKind::kNone:
      return "none";
    case VerdictKind::kEffect:
      return "effect";
    case VerdictKind::kParameter:
      return "parameter";
    case VerdictKind::kReference:
      return "reference";
    case VerdictKind::kUnknown:
      return "unknown";
  }
  return "";
}

bool staysBelowCeiling(const Decision& decision, const Rest& rest) {
  constexpr double kLeftByAnything = 0.1;  // of the gap
  const Candidate& winner = *decision.winner;
  if (winner.hypothesis.seen_in_values) return false;
  const double left = systematicallyLeft(rest, winner);
  if (left >= kLeftByAnything) return true;
  return rest.isPlain() && std::min(left, 1.0 - explainedBesideAny(decision)) >= kLeftByAPlainLaw;
}

const Candidate* pairWith(const Decision& decision, const Rival& rival) {
  const auto pair = std::find_if(decision.pairs.begin(), decision.pairs.end(), [&](const Candidate& candidate) {
    const std::optional<Rival> other = exchangedIn(candidate, *decision.winner);
    return other && other->name == rival.name && other->instead_of == rival.instead_of;
  });
  return pair == decision.pairs.end() ? nullptr : &*pair;
}

std::vector<std::pair<std::string, Candidate>> tiedPairs(const Decision& decision) {
  std::vector<std::pair<std::string, Candidate>> tied;
  for (const Rival& rival : decision.rivals) {
    const Candidate* const pair = rival.tied() ? pairWith(decision, rival) : nullptr;
    if (pair) tied.emplace_back(rival.name, *pair);
  }
  return tied;
}

std::vector<std::string> Decision::ties() const {
  std::vector<std::string> names;
  for (const Rival& rival : rivals) {
    if (rival.tied()) names.push_back(rival.name);
  }
  return names;
}

namespace {

/// The same pair with the effect before what is beside it: who reads the first cause wants what is named.
Candidate effectsFirst(const Candidate& candidate) {
  const std::vector<Candidate> members = membersOf(candidate);
  const auto isEffect = [](const Candidate& member) { return member.hypothesis.kind == CauseKind::kEffect; };
  if (members.size() < 2 || isEffect(members[0]) || !isEffect(members[1])) return candidate;
  Candidate turned = candidate;
  turned.hypothesis = together(members[1].hypothesis, members[0].hypothesis);
  turned.values = joined(members[1].values, members[0].values);
  return turned;
}

}  // namespace

void Decision::name(const Candidate& candidate) {
  winner = effectsFirst(candidate);
  kind = kindOf(membersOf(*winner).front().hypothesis.kind);
}

void Decision::nameNothing(Contradiction why) {
  contradiction = why;
  winner.reset();
  rivals.clear();
  recalibrations.clear();
  kind = VerdictKind::kUnknown;
}

std::vector<std::string> Decision::names() const {
  if (!winner) return {};
  if (!pair()) return {winner->hypothesis.name};
  std::vector<std::string> effects, all;
  for (const Hypothesis& member : winner->hypothesis.members) {
    all.push_back(member.name);
    if (member.kind == CauseKind::kEffect) effects.push_back(member.name);
  }
  return effects.empty() ? all : effects;
}

std::vector<std::string> Decision::beside() const {
  std::vector<std::string> others;
  if (!pair()) return others;
  const std::vector<std::string> named = names();
  for (const Hypothesis& member : winner->hypothesis.members)
    if (std::find(named.begin(), named.end(), member.name) == named.end()) others.push_back(member.name);
  return others;
}

Decision decide(const Judge& quick, const Judge& exact, const HeldOutGaps& gaps, bool clear, const WhereResult& where,
                const std::vector<Hypothesis>& hypotheses, core::Progress& progress) {
  Decision decision;
  decision.singles = rankedAlone(quick, exact, gaps, where, hypotheses, progress);
  if (decision.singles.empty()) {
    decision.kind = clear ? VerdictKind::kUnknown : VerdictKind::kNone;
    return decision;
  }
  if (!clear) {
    nameWhatProvesItself(quick, exact, gaps, where, decision, progress);
    return decision;
  }
  core::PartOfProgress part(progress, 0.5, 0.6);
  lookCloser(quick, exact, gaps, where, decision.singles, part);
  shareTheSector(exact, gaps, where, decision.singles, part);
  if (!namesAPair(quick, exact, gaps, where, decision, progress)) {
    nameTheBest(quick, exact, gaps, where, decision, progress);
  }
  return decision;
}

}  // namespace gap
