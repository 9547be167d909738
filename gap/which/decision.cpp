#include "gap/which/decision.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <span>

#include "core/parallel.h"
#include "gap/which/closer_look.h"
#include "gap/which/counter.h"
#include "gap/which/cross_fit.h"
#include "gap/which/exchanges.h"
#include "gap/which/leading_pairs.h"
#include "gap/which/pair_by_means.h"
#include "gap/which/pairs.h"
#include "gap/which/partners.h"
#include "gap/which/same_sector.h"
#include "gap/which/second_cause.h"
#include "gap/which/second_search.h"
#include "gap/which/significance.h"
#include "gap/which/whole_gap.h"

namespace gap {

namespace {

constexpr double kAccountsFor = 0.7;   // of the gap: what accounts for less is as likely wrong as right
constexpr double kWeakGap = 0.40;      // the least share, where the gap is hardly larger than the noise
constexpr double kLeastShrink = 0.05;  // of the total gap: of causes that move rays: less may be how edges cut beams
constexpr std::size_t kLookedAt = 8;   // of best merit, and as many that gain most: they may prove themselves
constexpr double kWorthALook = 1.0;    // standard deviations of the gain with few beams: with all it takes four of them
constexpr double kHopeless = 0.5;  // of what a cause must account for to be named: closer fits do not double a share
constexpr std::size_t kPairsHeard = 4;  // best ones: one of them may earn its second cause where the first does not
constexpr int kRoundsOfExchanges = 2;
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

/// A fit of two may have found better values for one of them than the fit of one did, and then the other is for
/// nothing: every single cause for which some pair has better values is judged anew with these.
void learnFrom(const std::vector<Candidate>& pairs, const Judge& quick, const Judge& exact, const HeldOutGaps& gaps,
               const WhereResult& where, std::vector<Candidate>& singles, const core::Progress& progress) {
  std::map<Form, std::vector<Candidate>> members;
  for (const Candidate& pair : pairs) {
    for (Candidate& member : membersOf(pair)) members[formOf(member.hypothesis)].push_back(std::move(member));
  }
  std::vector<Candidate> bettered = singles;
  core::parallelFor(singles.size(), 1, [&](std::size_t i, std::size_t) {
    const auto found = members.find(formOf(singles[i].hypothesis));
    if (found == members.end()) return;
    Candidate& best = bettered[i];
    quick.hear(best);
    for (Candidate& member : found->second) {
      core::stopIfCancelled(progress);
      quick.hear(member);
      if (better(member, best)) best = std::move(member);
    }
  });
  std::vector<Candidate> improved;
  for (std::size_t i = 0; i < singles.size(); ++i)
    if (bettered[i].values != singles[i].values) improved.push_back(std::move(bettered[i]));
  sortByMerit(improved);
  polish(exact, gaps, improved, where, progress);
  takeBetter(std::move(improved), singles);
}

/// Puts a cause before all others, in place of the same one with other values, if it is better than the best of them.
void takeTheLead(Candidate candidate, std::vector<Candidate>& singles) {
  if (!better(candidate, singles.front())) return;
  const auto same = singles.begin() + static_cast<std::ptrdiff_t>(placeOfForm(singles, candidate));
  *same = std::move(candidate);
  std::rotate(singles.begin(), same, same + 1);
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
    const Significance held_out = significanceOf(gains, restOf(exact_, world, nulls_.runs()));
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

/// Whether a world sends any ray another way than the baseline does, or to another place.
bool movesRays(const Replay& replay, const World& world) {
  return std::any_of(replay.samples().begin(), replay.samples().end(), [&](const ReplaySample& sample) {
    return geometryKey(world, *sample.sample) != geometryKey(replay.baseline(), *sample.sample);
  });
}

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
    return movesRays(exact.replay, world) ? shrinks() : gaps.with(world, progress).shrink.interval.high > 0.0;
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

/// The share of the gap that a cause must account for to be named.
double enoughToName(const Yardstick& yardstick) {
  return std::max(kWeakGap, kAccountsFor - 2.0 * yardstick.noiseOfShare());
}

/// Whether none of these explains so much that it may yet be named.
bool hopeless(const Yardstick& yardstick, const std::vector<Candidate>& candidates) {
  const double least = kHopeless * enoughToName(yardstick);
  return std::all_of(candidates.begin(), candidates.end(),
                     [&](const Candidate& candidate) { return candidate.explained < least; });
}

/// The best cause with what a second search finds beside it, where its own noise hides that. References take long, and
/// are corrected first where one is wrong.
std::vector<Candidate> smallSeconds(const Judge& quick, const Judge& exact, std::vector<Candidate> singles,
                                    core::Progress& progress) {
  const Candidate best = singles.front();
  std::erase_if(singles, [](const Candidate& single) { return single.hypothesis.kind == CauseKind::kReference; });
  return pairsBeside(quick, exact, best, singles, progress);
}

/// Names the first of some pairs; others of them may stand in a member's place.
void nameFirstOf(std::vector<Candidate>& pairs, const Judge& quick, const Judge& exact, Decision& decision) {
  decision.name(pairs.front());
  pairs.front() = *decision.winner;  // its members in the same order
  const double added = std::max(0.0, 1.0 - decision.singles.front().explained / pairs.front().explained);
  decision.rivals = rivalsInPairs(quick, exact, pairs, added);
}

/// Puts first the pair that is named, if any is. What may stand in a member's place shows only where it was fitted
/// beside the other member: where another pair leads after that, its members are exchanged, too.
void chooseLeader(const Judge& quick, const Judge& exact, const HeldOutGaps& gaps,
                  const std::vector<Candidate>& singles, std::vector<Candidate>& pairs,
                  const core::Progress& progress) {
  const Candidate nearest = nearestToFitted(quick, std::span(pairs).first(std::min(kLeaders, pairs.size())));
  if (!samePair(nearest, pairs.front())) exchangeMembersOf(nearest, quick, exact, gaps, singles, pairs, progress);
  for (int round = 0; round < kRoundsOfExchanges; ++round) {
    const Candidate led = pairs.front();
    exchangeMembersOf(led, quick, exact, gaps, singles, pairs, progress);
    leadByAll(quick, exact, pairs, addedBySecond(singles.front(), pairs));
    if (samePair(led, pairs.front())) break;
  }
  leadByPlainest(quick, exact, pairs, addedBySecond(singles.front(), pairs));
}

/// Who asks pairs whether their second causes earn their place, one of so many causes. `room`: the rest shows that
/// there may be one.
struct Asked {
  const Judge& quick;
  const Judge& exact;
  const HeldOutGaps& gaps;
  bool room;
  std::size_t causes;

  /// What comes nearest may only scatter as the rest of the first cause does, and leave what another one takes.
  [[nodiscard]] std::span<Candidate>::iterator firstThatEarns(std::span<Candidate> pairs, const Candidate& single,
                                                              double left_by_single) const {
    SecondProofs proofs(exact, single, causes);
    return std::find_if(pairs.begin(), pairs.end(), [&](const Candidate& pair) {
      if (exact.accountedFor(pair) < enoughToName(exact.yardstick) || restOfWholeGap(gaps, pair) > kMostRestOfPair)
        return false;
      return (room && earnsItsSecond(quick, exact, single, left_by_single, pair)) || proofs.of(pair);
    });
  }
};

/// The pair that takes what the single causes leave of the means, and the pair that earns its place, if there is one;
/// it must hold by all beams and on the total gap.
std::optional<Candidate> provenByMeans(const Judge& quick, const Judge& exact, const HeldOutGaps& gaps,
                                       const WhereResult& where, const Decision& decision,
                                       std::span<const Candidate> earning, const core::Progress& progress) {
  std::vector<Candidate> leaders(earning.begin(), earning.end());
  const auto singles = std::span(decision.singles).first(std::min(kLeaders, decision.singles.size()));
  leaders.insert(leaders.end(), singles.begin(), singles.end());
  const std::optional<Candidate> nearest = pairByMeans(quick, leaders, decision.pairs, progress);
  if (!nearest) return std::nullopt;
  std::vector<Candidate> polished{*nearest};
  polish(exact, gaps, polished, where, progress);
  const Candidate& pair = polished.front();
  const bool holds = exact.accountedFor(pair) >= enoughToName(exact.yardstick) &&
                     restOfWholeGap(gaps, pair) <= kMostRestOfPair &&
                     earnsItsSecondByMeans(quick, exact, decision.singles.front(), pair);
  return holds ? std::optional(pair) : std::nullopt;
}

/// Looks for two causes, and names them if both earn their place; the single causes learn from the joint fits.
bool namesAPair(const Judge& usual, const Judge& exact, const HeldOutGaps& gaps, const WhereResult& where,
                Decision& decision, core::Progress& progress) {
  const Candidate first = decision.singles.front();
  const double left_by_first = restOf(exact, first);
  const bool room = roomForASecond(exact, first, left_by_first);
  if (!room && !mayHideASecond(exact, first)) return false;
  const auto closely = room ? closeJudgeBeside(usual, exact, first, left_by_first) : nullptr;
  const Judge& quick = closely ? closely->judge : usual;
  core::PartOfProgress part(progress, 0.6, 0.85);
  std::vector<Candidate>& pairs = decision.pairs =
      room ? rankPairs(quick, decision.singles, part) : smallSeconds(quick, exact, decision.singles, part);
  if (hopeless(exact.yardstick, pairs)) return false;
  learnFrom(pairs, quick, exact, gaps, where, decision.singles, progress);
  if (room) joinLeaders(exact, decision.singles, pairs, progress);
  polish(exact, gaps, pairs, where, progress);
  chooseLeader(quick, exact, gaps, decision.singles, pairs, progress);
  const std::span heard = std::span(pairs).first(std::min(kPairsHeard, pairs.size()));
  for (const Candidate& pair : heard) takeTheLead(betterMember(exact, gaps, pair), decision.singles);
  const Candidate& best = decision.singles.front();
  const bool still_first = formOf(best.hypothesis) == formOf(first.hypothesis) && best.values == first.values;
  const Asked asked{quick, exact, gaps, room, decision.singles.size()};
  auto earning = asked.firstThatEarns(heard, best, still_first ? left_by_first : restOf(exact, best));
  if (earning == heard.end()) {
    // A cause of many numbers may come as near as a plainer one with a second beside it (a cloud, as fog beside dirt).
    std::vector<Candidate> by_price = decision.singles;
    leadByPlainest(quick, exact, by_price);
    const Candidate& plainest = by_price.front();
    if (plainest.hypothesis.name != best.hypothesis.name)
      earning = asked.firstThatEarns(heard, plainest, restOf(exact, plainest));
  }
  const std::span named(earning, earning == heard.end() ? earning : earning + 1);
  if (const auto proven = provenByMeans(quick, exact, gaps, where, decision, named, progress)) {
    std::erase_if(pairs, [&](const Candidate& pair) { return samePair(pair, *proven); });
    pairs.insert(pairs.begin(), *proven);
  } else if (!named.empty()) {
    std::rotate(heard.begin(), earning, earning + 1);
  } else {
    return false;
  }
  leadByPlainest(quick, exact, pairs, addedBySecond(best, pairs));
  nameFirstOf(pairs, quick, exact, decision);
  return true;
}

/// Names the best single cause if it accounts for enough, or if nothing else is left; a counter that the values show in
/// any case, and what earns its place beside it.
void nameTheBest(const Judge& quick, const Judge& exact, const HeldOutGaps& gaps, const WhereResult& where,
                 Decision& decision, core::Progress& progress) {
  leadByAll(quick, exact, decision.singles);
  leadByPlainest(quick, exact, decision.singles);
  leadOnTotal(exact, gaps, enoughToName(exact.yardstick), decision.singles, progress);
  const Candidate& best = decision.singles.front();
  const bool explains = best.hypothesis.seen_in_values || best.explained >= kNearlyAllCells ||
                        exact.accountedFor(best) >= enoughToName(exact.yardstick) ||
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

bool staysBelowCeiling(const Candidate& winner, double left) {
  constexpr double kLeftByALaw = 0.1;  // of the gap
  if (winner.hypothesis.seen_in_values) return false;
  return std::min({left, 1.0 - winner.explained, winner.total_left}) >= kLeftByALaw;
}

std::vector<std::pair<std::string, Candidate>> tiedPairs(const Decision& decision) {
  std::vector<std::pair<std::string, Candidate>> tied;
  for (const Rival& rival : decision.rivals) {
    const auto pair = std::find_if(decision.pairs.begin(), decision.pairs.end(), [&](const Candidate& candidate) {
      const std::optional<Rival> other = exchangedIn(candidate, *decision.winner);
      return other && other->name == rival.name && other->instead_of == rival.instead_of;
    });
    if (rival.tied() && pair != decision.pairs.end()) tied.emplace_back(rival.name, *pair);
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
