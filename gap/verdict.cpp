#include "gap/verdict.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gap/candidates/enough.h"
#include "gap/candidates/whole_gap.h"
#include "gap/causes/scale.h"
#include "gap/which/belief.h"

namespace gap {

bool Verdict::isNamed(const std::string& cause) const {
  return std::find(names.begin(), names.end(), cause) != names.end();
}

bool Verdict::isBeside(const std::string& cause) const {
  return std::find(beside.begin(), beside.end(), cause) != beside.end();
}

namespace {

/// docs/diagnosis.md gives the reasons for these bounds.
constexpr double kWeakBelief = 0.9;     // of the belief, if no whole sample could be held out
constexpr double kLeastNamed = 0.7;     // of a cause that is named alone and tied with none, however little it explains
constexpr double kUnknownBelief = 0.7;  // that no cause of the library is at work, where none was found good enough
constexpr double kUnknownOfSmall = 0.4;  // the same of a gap hardly above noise
constexpr double kByMeansAlone = 0.5;    // of the belief in two causes that leave too much of single cells
constexpr double kAnywhere = 0.6;        // of the belief in what may be where and as large as it has to be
constexpr double kBesideFrames = 0.7;  // of the belief in a cause, where frames deviate, too: something else is at work
constexpr double kNoneBelief = 0.85;   // that nothing is missing, where nothing is seen: weak causes are not
constexpr double kMostExplained = 10.0;  // said of a share: where there is next to nothing to explain, it says nothing

/// How far it is believed that nothing is missing where noise makes so large a gap with this p-value. No alternative of
/// weak causes has a Bayes factor of the null below -e p ln p, for p < 1/e. Source: Sellke, Bayarri, Berger 2001,
/// Calibration of p Values for Testing Precise Null Hypotheses, The American Statistician 55, 62-71,
/// doi:10.1198/000313001300339950.
double beliefInNone(double p_value) {
  if (p_value >= 1.0 / std::numbers::e) return kNoneBelief;
  const double null_over_cause = -std::numbers::e * p_value * std::log(p_value) * kNoneBelief / (1.0 - kNoneBelief);
  return null_over_cause / (1.0 + null_over_cause);
}

Cause toCause(const Candidate& candidate) {
  Cause cause;
  cause.kind = candidate.hypothesis.kind;
  cause.name = candidate.hypothesis.name;
  cause.variant = candidate.hypothesis.variant;
  cause.sensors = candidate.hypothesis.sensors;
  cause.percollect = candidate.hypothesis.percollect;
  cause.decomposition_block = candidate.hypothesis.decomposition_block;
  cause.explained = std::clamp(candidate.explained, 0.0, 1.0);
  for (std::size_t i = 0; i < candidate.values.size(); ++i) {
    const FreeParameter& p = candidate.hypothesis.parameters[i];
    FittedParameter fitted{
        .name = p.name, .unit = p.unit, .value = candidate.values[i], .plausible = Interval{p.low, p.high}};
    if (cause.kind == CauseKind::kParameter) fitted.recorded = p.start;
    fitted.at_end = !candidate.hypothesis.seen_in_values && atUpperEnd(p, candidate.values[i]);
    if (candidate.hypothesis.per_setup) {
      cause.setups[p.name] = fitted;
    } else {
      cause.parameters.push_back(fitted);
    }
  }
  return cause;
}

/// That a cause is at work, before others are compared with it.
double beliefIn(const Judge& judge, const Candidate& candidate) {
  const double accounted_for = candidate.hypothesis.seen_in_values ? 1.0 : judge.accountedFor(candidate);
  return beliefIn(judge.yardstick, accounted_for, candidate.hypothesis.kind);
}

/// Few data never make a verdict that anybody should rely upon, whatever they seem to say.
void heedLimits(Diagnosis& diagnosis) {
  Verdict& verdict = diagnosis.verdict;
  const double most = mostConfidence(verdict.limits.size());
  verdict.confidence = std::min(verdict.confidence, most);
  for (Cause& cause : diagnosis.causes) cause.confidence = std::min(cause.confidence, most);
}

/// A cause that was found by way of a proxy is as good as the proxy.
void heedApproximation(Diagnosis& diagnosis) {
  if (!diagnosis.approximation || diagnosis.verdict.kind == VerdictKind::kNone)
    return;  // no proxy takes part in `none`
  const double trust = diagnosis.approximation->trust();
  for (Cause& cause : diagnosis.causes) cause.confidence *= trust;
  if (!diagnosis.verdict.names.empty()) diagnosis.verdict.confidence *= trust;
}

/// Of the winner; of the best cause where none was found good enough.
VerdictEvidence evidenceOf(const Judge& judge, const Decision& decision) {
  VerdictEvidence evidence{.gap_z = judge.yardstick.z()};
  if (decision.singles.empty()) return evidence;
  const Candidate& best = decision.winner ? *decision.winner : decision.singles.front();
  evidence.explained = std::clamp(best.explained, -kMostExplained, kMostExplained);
  evidence.total_left = best.total_left;
  const auto& rivals = decision.pair() ? decision.pairs : decision.singles;
  const auto next = std::find_if(rivals.begin(), rivals.end(), [&](const Candidate& candidate) {
    return candidate.hypothesis.name != best.hypothesis.name;
  });
  if (next != rivals.end()) evidence.lead = best.merit - next->merit;
  return evidence;
}

/// Of those that were tried, where it says notably more than the best single cause.
std::optional<NearestPair> nearestPairIn(const Decision& decision) {
  constexpr double kNotably = 0.05, kHalf = 0.5;  // of the gap
  if (decision.pairs.empty() || decision.singles.empty()) return std::nullopt;
  const Candidate& pair = decision.pairs.front();
  if (pair.explained < std::max(kHalf, decision.singles.front().explained + kNotably)) return std::nullopt;
  NearestPair nearest{{}, std::min(1.0, pair.explained)};
  for (const Candidate& member : membersOf(pair)) nearest.names.push_back(member.hypothesis.name);
  return nearest;
}

bool mayBeAnywhere(const Candidate& candidate) {
  const std::vector<Candidate> members = membersOf(candidate);
  return std::any_of(members.begin(), members.end(), [](const Candidate& m) { return m.hypothesis.anywhere; });
}

double confidenceIn(const Diagnosis& diagnosis, const std::string& name) {
  const auto cause = std::find_if(diagnosis.causes.begin(), diagnosis.causes.end(),
                                  [&](const Cause& listed) { return listed.name == name; });
  return cause == diagnosis.causes.end() ? 0.0 : cause->confidence;
}

}  // namespace

void fillCauses(const Judge& judge, const HeldOutGaps& gaps, const Decision& decision, bool frames_deviate,
                Diagnosis& diagnosis, const core::Progress& progress) {
  constexpr std::size_t kListed = 6;
  // Pooled data show no map, so what a cause does to single beams is not seen.
  const bool pooled = judge.replay.samples().front().layout->pooled();
  const bool by_means = decision.pair() && decision.winner->explained < enoughForTwo(judge.yardstick);
  const double most = (judge.split.weak || pooled ? kWeakBelief : 1.0) * (frames_deviate ? kBesideFrames : 1.0) *
                      (by_means ? kByMeansAlone : 1.0);
  const double named = decision.winner ? kLeastNamed : 0.0;
  const auto beliefOf = [&](const Candidate& candidate) {
    return most * (mayBeAnywhere(candidate) ? kAnywhere : 1.0) * std::max(named, beliefIn(judge, candidate));
  };
  const auto confidences =
      decision.singles.empty() ? std::vector<double>{} : confidencesOf(decision, beliefOf(decision.singles.front()));
  std::vector<std::string> listed;
  const auto list = [&](const Candidate& candidate, double confidence) {
    diagnosis.causes.push_back(toCause(candidate));
    diagnosis.causes.back().confidence = confidence;
    listed.push_back(candidate.hypothesis.name);
  };
  if (decision.pair()) {
    const double belief = beliefOf(*decision.winner);
    for (const Candidate& member : membersOf(*decision.winner))
      list(member, belief * shareOf(decision, member.hypothesis.name));
    for (const auto& [name, pair] : tiedPairs(decision)) {
      for (const Candidate& member : membersOf(pair))
        if (member.hypothesis.name == name) list(member, belief * shareOf(decision, name));
      diagnosis.causes.back().shrink = gaps.with(worldOf(judge.replay, pair.hypothesis, pair.values), progress).shrink;
    }
  }
  for (std::size_t i = 0; i < decision.singles.size() && diagnosis.causes.size() < kListed; ++i) {
    const Candidate& candidate = decision.singles[i];
    if (std::find(listed.begin(), listed.end(), candidate.hypothesis.name) != listed.end()) continue;
    const bool is_winner = decision.winner && !decision.pair() && i == 0;
    if (candidate.explained < 0.02 && !is_winner) break;
    list(candidate, decision.pair() ? 0.05 * confidences[i] : confidences[i]);
    if (is_winner) continue;
    const World world = worldOf(judge.replay, candidate.hypothesis, candidate.values);
    diagnosis.causes.back().shrink = gaps.with(world, progress).shrink;
  }
}

Stray strayIn(const Decision& decision) {
  const bool explained = decision.winner && decision.winner->explained >= kNearlyAllCells;
  return explained ? Stray::kExplained : Stray::kUnexplained;
}

void fillVerdict(const Judge& judge, const Decision& decision, Diagnosis& diagnosis) {
  Verdict& verdict = diagnosis.verdict;
  verdict.kind = decision.kind;
  verdict.contradiction = decision.contradiction;
  diagnosis.present = decision.kind != VerdictKind::kNone;
  if (decision.winner) {
    verdict.names = decision.names();
    verdict.beside = decision.beside();
    verdict.confidence = diagnosis.causes.front().confidence;
    if (decision.pair()) verdict.confidence = std::min(verdict.confidence, diagnosis.causes[1].confidence);
    verdict.indistinguishable_from = decision.ties();
    if (!decision.pair() && verdict.indistinguishable_from.size() == 1)
      verdict.confidence += confidenceIn(diagnosis, decision.ties().front());
  } else if (verdict.kind == VerdictKind::kNone) {
    const double p_value = judge.yardstick.p_value();
    verdict.confidence = p_value >= kSignificance ? beliefInNone(p_value) : kNoneBelief;
  } else {
    verdict.confidence = judge.yardstick.z() < Yardstick::kClear_z ? kUnknownOfSmall : kUnknownBelief;
    verdict.nearest_pair = nearestPairIn(decision);
    for (Cause& cause : diagnosis.causes) cause.confidence *= 1.0 - verdict.confidence;
  }
  verdict.evidence = evidenceOf(judge, decision);
  verdict.limits = limitsOf(judge.replay, judge.split, strayIn(decision));
  heedApproximation(diagnosis);
  heedLimits(diagnosis);
}

}  // namespace gap
