#include "gap/decision.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "gap/pairs.h"
#include "gap/significance.h"

namespace gap {

namespace {

constexpr double kAccountsFor = 0.65;  // share of the gap that a cause must account for to be named, if nothing else
constexpr double kBeliefWidth = 0.07;  // of that share: from a cause that is as likely wrong to one that is hardly ever
constexpr double kWeakGap = 0.40;      // the least share, where the gap is hardly larger than the noise
constexpr double kMaterialRest = 0.04;   // pairs are tried if the best cause leaves more of the total gap,
constexpr double kMaterialCells = 0.08;  // or of the discrepancy
constexpr double kPairGain = 0.5;        // a pair must halve what its best member leaves
constexpr double kTotalGain = 0.35;      // of the total gap, which counts what no physics explains too, even more
constexpr double kMostRestOfPair = 0.5;  // of the total gap: two causes that leave more are not the causes
constexpr double kSecondProven = 4.0;    // standard deviations by which a pair must be nearer than its better member
constexpr double kMostBelief = 0.97;     // in anything
constexpr double kProven = 4.5;          // standard deviations: one in a hundred, for sixty causes and 16 runs
constexpr double kNoRest = 3.0;          // standard deviations: no more is left than under the cause's own noise
constexpr double kMostSamples = 0.75;    // share of the held-out samples that a small cause must bring nearer
constexpr double kLeastShrink = 0.05;    // of the total gap: less is nobody's concern
constexpr double kApart = 1.5;           // standard deviations of the paired difference of two causes
constexpr double kFarBehind = 0.15;      // in merit: no rival, however alike in single cells
constexpr std::size_t kRivals = 5;
constexpr double kTie = 0.03;  // of what there is to explain: causes this close cannot be told apart

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

/// What a candidate leaves on the held-out samples: of the discrepancy, and of the total gap (formats.md section 6)
/// beyond what a right model keeps.
struct LeftOver {
  double discrepancy = 1.0;
  double total = 1.0;
};

LeftOver leftBy(const Candidate& candidate) { return {std::max(0.0, 1.0 - candidate.explained), candidate.total_left}; }

/// A fit of two may have found better values for one of them than the fit of one did, and then the other is for
/// nothing: every single cause for which some pair has better values is judged anew with these.
void learnFrom(const std::vector<Candidate>& pairs, const Judge& quick, const Judge& exact, const HeldOutGaps& gaps,
               const std::vector<WhereRow>& where, std::vector<Candidate>& singles, const core::Progress& progress) {
  std::map<Form, std::vector<Candidate>> members;
  for (const Candidate& pair : pairs) {
    for (Candidate& member : membersOf(pair)) members[formOf(member.hypothesis)].push_back(std::move(member));
  }
  std::vector<Candidate> improved;
  for (const Candidate& single : singles) {
    const auto found = members.find(formOf(single.hypothesis));
    if (found == members.end()) continue;
    Candidate best = single;
    quick.hear(best);
    for (Candidate& member : found->second) {
      quick.hear(member);
      if (better(member, best)) best = std::move(member);
    }
    if (best.values != single.values) improved.push_back(std::move(best));
  }
  sortByMerit(improved);
  polish(exact, gaps, improved, where, progress);
  for (Candidate& candidate : improved) {
    const auto single = std::find_if(singles.begin(), singles.end(), [&](const Candidate& c) {
      return formOf(c.hypothesis) == formOf(candidate.hypothesis);
    });
    if (better(candidate, *single)) *single = std::move(candidate);
  }
  sortByMerit(singles);
}

/// Whether a second cause could earn its place at all: no pair can gain more than what the best single cause leaves.
bool roomForASecond(const LeftOver& single, double noise) {
  return (single.total > kMaterialRest || single.discrepancy > kMaterialCells) && single.discrepancy > 3.0 * noise;
}

/// A second cause must halve what the best single one leaves, in the discrepancy or in the total gap, by more than the
/// noise of the explained share.
bool earnsItsSecond(const LeftOver& single, const LeftOver& pair, double noise) {
  const double gain = single.discrepancy - pair.discrepancy;
  const bool no_larger =
      pair.total < single.total + kMaterialRest;  // what helps the cells must not harm the pooled gap
  const bool closer = pair.discrepancy < kPairGain * single.discrepancy && gain > 0.05 && no_larger;
  const bool smaller = pair.total < kTotalGain * single.total;
  return roomForASecond(single, noise) && gain > 3.0 * noise && (closer || smaller);
}

/// A gain that no noise of the baseline makes, and nothing left that the cause itself would not leave.
bool nothingElse(const Significance& significance) {
  return significance.improvement_z > kProven && significance.rest_z < kNoRest;
}

/// Free numbers that are not where the cause is absent: an effect may have several mechanisms, of which one is at work.
double numbersAtWork(const Candidate& candidate) {
  constexpr double kNothing = 0.01;  // of the range
  double count = 0.0;
  for (std::size_t i = 0; i < candidate.values.size(); ++i) {
    const FreeParameter& p = candidate.hypothesis.parameters[i];
    count += std::abs(candidate.values[i] - p.absent_at) > kNothing * (p.high - p.low) || p.logarithmic ? 1.0 : 0.0;
  }
  return count;
}

/// How well the best one is told from each cause that comes near to it. One that needs more numbers to say the same is
/// less likely by their price.
std::vector<Rival> rivalsOf(const Judge& judge, const std::vector<Candidate>& candidates) {
  const Candidate& best = candidates.front();
  const double alike = kTie * judge.yardstick.whole();
  std::vector<Rival> rivals;
  for (std::size_t i = 1; i < candidates.size() && rivals.size() < kRivals; ++i) {
    Candidate candidate = candidates[i];
    const std::string& name = candidate.hypothesis.name;
    const bool known = std::any_of(rivals.begin(), rivals.end(), [&](const Rival& r) { return r.name == name; });
    if (name == best.hypothesis.name || known) continue;
    if (candidate.merit < best.merit - kFarBehind) break;
    judge.hear(candidate);  // few beams may have been all that it was judged by so far
    const bool same = candidate.discrepancy < best.discrepancy + alike;
    const double apart = same ? 0.0 : std::max(0.0, separation(judge, best, candidate));
    const double more_numbers = std::max(0.0, numbersAtWork(candidate) - numbersAtWork(best));
    rivals.push_back({name, std::sqrt(apart * apart + 2.0 * Judge::kNatsPerNumber * more_numbers)});
  }
  return rivals;
}

/// Where little is to be explained, edges prove nothing: whether a beam still grazes a bright surface, a millimetre
/// decides, or the number of rays, and a faint halo explains the few echoes that only one program has.
Judge withoutEdges(Judge judge) {
  judge.split.held_out.part.edges = false;
  return judge;
}

bool provesItself(const Significance& significance, double shrink) {
  return nothingElse(significance) && significance.better_samples >= kMostSamples && shrink > kLeastShrink;
}

}  // namespace

double beliefIn(double accounted_for) {
  return kMostBelief / (1.0 + std::exp((kAccountsFor - accounted_for) / kBeliefWidth));
}

std::vector<double> confidencesOf(const Decision& decision, double belief) {
  const std::vector<Candidate>& candidates = decision.singles;
  std::vector<double> confidences(candidates.size(), 0.0);
  if (candidates.empty()) return confidences;
  confidences.front() = 1.0;
  double sum = 1.0;
  for (const Rival& rival : decision.rivals) {
    const auto place = std::find_if(candidates.begin(), candidates.end(),
                                    [&](const Candidate& c) { return c.hypothesis.name == rival.name; });
    if (place == candidates.end()) continue;
    const double share = std::exp(-0.5 * rival.separation * rival.separation);
    confidences[static_cast<std::size_t>(place - candidates.begin())] = share;
    sum += share;
  }
  for (double& confidence : confidences) confidence *= belief / sum;
  return confidences;
}

std::vector<std::string> Decision::ties() const {
  std::vector<std::string> names;
  for (const Rival& rival : rivals) {
    if (rival.separation < kApart) names.push_back(rival.name);
  }
  return names;
}

void Decision::name(const Candidate& candidate) {
  const std::vector<Candidate> members = membersOf(candidate);
  const bool an_effect = std::any_of(members.begin(), members.end(), [](const Candidate& member) {
    return member.hypothesis.kind == CauseKind::kEffect;
  });
  winner = candidate;
  kind = an_effect ? VerdictKind::kEffect : kindOf(members.front().hypothesis.kind);
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

Decision decide(const Judge& quick, const Judge& exact, const HeldOutGaps& gaps, bool clear,
                const std::vector<WhereRow>& where, const std::vector<Hypothesis>& hypotheses,
                core::Progress& progress) {
  Decision decision;
  core::PartOfProgress first(progress, 0.1, 0.6), second(progress, 0.6, 0.85);
  decision.singles = rank(quick, hypotheses, where, first);
  polish(exact, gaps, decision.singles, where, progress);
  if (decision.singles.empty()) {
    decision.kind = clear ? VerdictKind::kUnknown : VerdictKind::kNone;
    return decision;
  }
  const double noise = std::sqrt(2.0) * exact.yardstick.perfect_spread / exact.yardstick.whole();
  const double enough = std::max(kWeakGap, kAccountsFor - 2.0 * noise);
  if (clear && roomForASecond(leftBy(decision.singles.front()), noise)) {
    std::vector<Candidate>& pairs = decision.pairs = rankPairs(quick, decision.singles, second);
    learnFrom(pairs, quick, exact, gaps, where, decision.singles, progress);
    polish(exact, gaps, pairs, where, progress);
    if (!pairs.empty() && exact.accountedFor(pairs.front()) >= enough) {
      const Candidate &pair = pairs.front(), &best = decision.singles.front();
      if (earnsItsSecond(leftBy(best), leftBy(pair), noise) && pair.total_left <= kMostRestOfPair &&
          separation(exact, pair, best) >= kSecondProven) {
        decision.name(pair);
        return decision;
      }
    }
  }
  const Candidate& best = decision.singles.front();
  const Significance significance = significanceOf(clear ? exact : withoutEdges(exact), best);
  decision.p_value = std::min(1.0, significance.p_value * static_cast<double>(decision.singles.size()));
  const World world = worldOf(exact.replay, best.hypothesis, best.values);
  if (!clear && !provesItself(significance, gaps.shrinkTo(gaps.totalIn(world)))) {
    decision.kind = VerdictKind::kNone;
    return decision;
  }
  const bool explains = exact.accountedFor(best) >= enough || (best.explained >= kWeakGap && nothingElse(significance));
  if (!clear || explains) {
    decision.name(best);
    decision.rivals = rivalsOf(exact, decision.singles);
  }
  return decision;
}

}  // namespace gap
