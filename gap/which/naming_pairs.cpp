#include "gap/which/naming_pairs.h"

#include <algorithm>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include "core/parallel.h"
#include "core/progress.h"
#include "gap/candidates/closer_look.h"
#include "gap/candidates/enough.h"
#include "gap/candidates/polish.h"
#include "gap/candidates/whole_gap.h"
#include "gap/pairs/exchanges.h"
#include "gap/pairs/leading_pairs.h"
#include "gap/pairs/pair_by_means.h"
#include "gap/pairs/pairs.h"
#include "gap/pairs/partners.h"
#include "gap/pairs/second_cause.h"
#include "gap/pairs/second_search.h"
#include "gap/pairs/untouched.h"
#include "gap/unexplained/rest.h"

namespace gap {

namespace {

constexpr double kHopeless = 0.5;  // of what a cause must account for to be named: closer fits do not double a share
constexpr std::size_t kPairsHeard = 4;  // best ones: one of them may earn its second cause where the first does not
constexpr int kRoundsOfExchanges = 2;

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

/// Puts a cause before all others, in place of the same one with other values.
void putFirst(Candidate candidate, std::vector<Candidate>& singles) {
  const auto same = singles.begin() + static_cast<std::ptrdiff_t>(placeOfForm(singles, candidate));
  *same = std::move(candidate);
  std::rotate(singles.begin(), same, same + 1);
}

/// The same, if it is better than the best of them.
void takeTheLead(Candidate candidate, std::vector<Candidate>& singles) {
  if (better(candidate, singles.front())) putFirst(std::move(candidate), singles);
}

/// Whether none of these explains so much that it may yet be named.
bool hopeless(const Yardstick& yardstick, const std::vector<Candidate>& candidates) {
  const double least = kHopeless * enoughToName(yardstick);
  return std::all_of(candidates.begin(), candidates.end(),
                     [&](const Candidate& candidate) { return candidate.explained < least; });
}

/// Whether a pair explains so much of the cells, and accounts for so much of the gap, that it may be named.
bool explainsEnough(const Judge& judge, const Candidate& pair) {
  return pair.explained >= enoughForTwo(judge.yardstick) && judge.accountedFor(pair) >= enoughToName(judge.yardstick);
}

/// The best cause with what a second search finds beside it, where its own noise hides that. References take long, and
/// are corrected first where one is wrong.
std::vector<Candidate> smallSeconds(const Judge& quick, const Judge& exact, std::vector<Candidate> singles,
                                    core::Progress& progress) {
  const Candidate best = singles.front();
  std::erase_if(singles, [](const Candidate& single) { return single.hypothesis.kind == CauseKind::kReference; });
  return pairsBeside(quick, exact, best, singles, progress);
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
      if (!explainsEnough(exact, pair) || restOfWholeGap(gaps, pair) > kMostRestOfPair) return false;
      return (room && earnsItsSecond(quick, exact, single, left_by_single, pair)) || proofs.of(pair);
    });
  }
};

/// The first pair that earns its second cause beside the best single cause; if none does, beside the plainest that
/// cannot be told from it: a cause of many numbers may come as near as a plainer one with a second (a cloud, as fog and
/// dirt).
std::span<Candidate>::iterator thatEarns(const Asked& asked, std::span<Candidate> heard,
                                         const std::vector<Candidate>& singles, double left_by_best) {
  const Candidate& best = singles.front();
  const auto earning = asked.firstThatEarns(heard, best, left_by_best);
  if (earning != heard.end()) return earning;
  std::vector<Candidate> by_price = singles;
  leadByPlainest(asked.quick, asked.exact, by_price);
  const Candidate& plainest = by_price.front();
  if (plainest.hypothesis.name == best.hypothesis.name) return earning;
  return asked.firstThatEarns(heard, plainest, deviationsLeft(asked.exact, plainest));
}

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

/// Looks for two causes that earn their place in all aspects together.
bool namesTogether(const Judge& usual, const Judge& exact, const HeldOutGaps& gaps, const WhereResult& where,
                   Decision& decision, core::Progress& progress) {
  const Candidate first = decision.singles.front();
  const double left_by_first = deviationsLeft(exact, first);
  const bool room = roomForASecond(exact, first, left_by_first) || leavesAPlainLaw(exact, where, first);
  if (!room && !mayHideASecond(exact, first)) return false;
  const auto closely = room ? closeJudgeBeside(usual, exact, first, left_by_first) : nullptr;
  const Judge& quick = closely ? closely->judge : usual;
  std::vector<Candidate>& pairs = decision.pairs =
      room ? rankPairs(quick, decision.singles, progress) : smallSeconds(quick, exact, decision.singles, progress);
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
  const auto earning =
      thatEarns(asked, heard, decision.singles, still_first ? left_by_first : deviationsLeft(exact, best));
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
  // A plain cause beside one that adds nothing may come as near as two that are needed: then it is the cause.
  Candidate alone = betterMember(exact, gaps, pairs.front());
  if (doesAsWellAlone(quick, exact, alone, pairs.front())) {
    putFirst(std::move(alone), decision.singles);
    return false;
  }
  nameFirstOf(pairs, quick, exact, decision);
  return true;
}

/// Looks for a second cause beside the best single one where that one does nothing; it must hold in all aspects and on
/// the total gap, too.
bool namesWhereUntouched(const Judge& quick, const Judge& exact, const HeldOutGaps& gaps, const WhereResult& where,
                         Decision& decision, core::Progress& progress) {
  const Candidate& best = decision.singles.front();
  if (hopeless(exact.yardstick, {best})) return false;
  const WhereUntouched there(exact, best);
  if (!there.missesSomething()) return false;
  std::vector<Candidate> pairs = there.pairs(quick, decision.singles, progress);
  polish(exact, gaps, pairs, where, progress);
  const auto holds = [&](const Candidate& pair) {
    return explainsEnough(exact, pair) && earnsItsSecondElsewhere(quick, exact, best, pair, there.nothingLeftBy(pair));
  };
  const auto named = std::find_if(pairs.begin(), pairs.end(), holds);
  if (named == pairs.end()) return false;
  std::vector<Candidate> all{*named};
  pairs.erase(named);
  for (std::vector<Candidate>* const some : {&pairs, &decision.pairs}) {
    for (Candidate& pair : *some)
      if (std::none_of(all.begin(), all.end(), [&](const Candidate& one) { return samePair(one, pair); }))
        all.push_back(std::move(pair));
  }
  decision.pairs = std::move(all);
  leadByPlainest(quick, exact, decision.pairs, addedBySecond(best, decision.pairs));
  nameFirstOf(decision.pairs, quick, exact, decision);
  return true;
}

}  // namespace

void nameFirstOf(std::vector<Candidate>& pairs, const Judge& quick, const Judge& exact, Decision& decision) {
  decision.name(pairs.front());
  pairs.front() = *decision.winner;  // its members in the same order
  const double added = std::max(0.0, 1.0 - decision.singles.front().explained / pairs.front().explained);
  decision.rivals = rivalsInPairs(quick, exact, pairs, added);
  decision.recalibrations = recalibrationsInPairs(quick, exact, pairs, added);
}

bool namesAPair(const Judge& usual, const Judge& exact, const HeldOutGaps& gaps, const WhereResult& where,
                Decision& decision, core::Progress& progress) {
  core::PartOfProgress part(progress, 0.6, 0.85);
  return namesTogether(usual, exact, gaps, where, decision, part) ||
         namesWhereUntouched(usual, exact, gaps, where, decision, part);
}

}  // namespace gap
