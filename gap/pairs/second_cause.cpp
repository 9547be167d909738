#include "gap/pairs/second_cause.h"

#include <algorithm>
#include <cmath>

#include "gap/candidates/separation.h"
#include "gap/candidates/significance.h"
#include "gap/candidates/whole_gap.h"
#include "gap/far/how_far.h"

namespace gap {

namespace {

constexpr double kMaterialRest = 0.04;   // pairs are tried if the best cause leaves more of the total gap,
constexpr double kMaterialCells = 0.08;  // or of the discrepancy
constexpr double kPooledRest = 0.2;      // of the total gap: the cells may not show it, as they do not show rare echoes
constexpr double kPairGain = 0.5;        // a pair must halve what its best member leaves
constexpr double kLeastGain = 0.04;      // in that,
constexpr double kNearlyAll = 0.8;       // or take so much of what it leaves,
constexpr double kTotalGain = 0.35;      // of the total gap, which counts what no physics explains too, even more
constexpr double kSecondProven = 4.0;    // standard deviations by which a pair must be nearer than its better member
constexpr double kNoisier = 3.0;         // standard deviations of a right model's noise: a cause's own is larger
constexpr std::size_t kNoiseRuns = 10;
constexpr double kOfTheWay = 0.75;  // from what a pair gains where its second is not there to where it is

/// What a candidate leaves on the held-out samples: of the discrepancy, and of the total gap (formats.md section 6)
/// beyond what a right model keeps.
struct LeftOver {
  double discrepancy = 1.0;
  double total = 1.0;
};

LeftOver leftBy(const Candidate& candidate) { return {std::max(0.0, 1.0 - candidate.explained), candidate.total_left}; }

/// A second cause must halve what the best single one leaves, cell by cell or of the whole gap, or leave still less of
/// the total gap; and what helps the cells must not harm the total gap, unless it leaves next to nothing of them.
bool earnsByShare(const Judge& judge, const Candidate& single, const Candidate& pair) {
  const LeftOver of_single = leftBy(single), of_pair = leftBy(pair);
  const auto halves = [](double before, double after) {
    return after < kPairGain * before && before - after > kLeastGain;
  };
  const bool harms_nothing = of_pair.total < of_single.total + kMaterialRest || pair.explained >= kNearlyAllCells;
  const bool closer = halves(of_single.discrepancy, of_pair.discrepancy) && harms_nothing;
  const bool accounts = halves(1.0 - judge.accountedFor(single), 1.0 - judge.accountedFor(pair)) && harms_nothing;
  const bool smaller = of_pair.total < kTotalGain * of_single.total;
  return of_pair.discrepancy < of_single.discrepancy && (closer || accounts || smaller);
}

/// A pair that leaves nothing where its better member leaves something proves its second cause, however small a part of
/// the gap that is: if it halves what is left where all data are pooled, or if what that member leaves would itself be
/// a gap beyond doubt.
bool leavesNothing(const Judge& judge, const Candidate& single, double left_by_single, const Candidate& pair) {
  if (left_by_single < kNoRest || deviationsLeft(judge, pair) > kNoRest) return false;
  const bool halves = pair.total_left < kPairGain * single.total_left;
  const bool beyond_doubt = left_by_single > Yardstick::kClear_z && pair.total_left < single.total_left + kMaterialRest;
  return halves || beyond_doubt;
}

/// Of a gap a thousand times its noise, a fiftieth is more than many a gap: a second cause that takes nearly all of
/// what the better member leaves of the cells, and half of what it leaves of the total gap, needs no least gain, if
/// that would itself be a gap beyond doubt.
bool takesNearlyAll(const Candidate& single, double left_by_single, const Candidate& pair) {
  const LeftOver of_single = leftBy(single), of_pair = leftBy(pair);
  return of_pair.discrepancy < (1.0 - kNearlyAll) * of_single.discrepancy &&
         of_pair.total < kPairGain * of_single.total && left_by_single > Yardstick::kClear_z;
}

/// Whether what is beside a wrong reference may be no more than what the reference leaves: where it puts edges decides
/// on as much as a small effect does, so nothing may be left with both. Otherwise the reference is to be corrected
/// first.
bool explainsWhatAReferenceLeaves(const Judge& judge, const Candidate& best, const Candidate& pair) {
  const auto& members = pair.hypothesis.members;
  return best.hypothesis.kind == CauseKind::kReference &&
         std::any_of(members.begin(), members.end(),
                     [&](const Hypothesis& member) { return member.name == best.hypothesis.name; }) &&
         deviationsLeft(judge, pair) > kNoRest;
}

/// Whether a pair says less than one cause of many numbers (a cloud has four, fog behind a wrong power two) and leaves
/// no more of the total gap. Which of some sixty causes the second is costs as much as a number does, four nats.
bool saysLess(const Candidate& pair, const Candidate& single) {
  return pair.values.size() + 1 < single.values.size() && pair.total_left < single.total_left + kMaterialRest;
}

/// Whether a pair is nearer to the data than its better member by more than luck: on held-out samples, or on all, where
/// every number more that was fitted has its price.
bool isNearer(const Judge& quick, const Judge& exact, const Candidate& pair, const Candidate& best) {
  double more = static_cast<double>(pair.values.size()) - static_cast<double>(best.values.size());
  more = saysLess(pair, best) ? more + 1.0 : std::max(0.0, more);
  const double least_on_all =
      std::sqrt(std::max(0.0, kSecondProven * kSecondProven + 2.0 * Judge::kNatsPerNumber * more));
  return separation(exact, pair, best) >= kSecondProven ||
         separationOnAll(quick, exact, pair, best, 0.0) >= least_on_all;
}

}  // namespace

bool roomForASecond(const Judge& judge, const Candidate& best, double left_by_best) {
  const LeftOver left = leftBy(best);
  const bool material = left.total > kMaterialRest || left.discrepancy > kMaterialCells;
  if (material && (left.total > kPooledRest || left.discrepancy > 3.0 * judge.yardstick.noiseOfShare())) return true;
  return left_by_best > (material ? kNoRest : Yardstick::kClear_z);
}

bool mayHideASecond(const Judge& judge, const Candidate& best) {
  if (best.hypothesis.kind != CauseKind::kEffect) return false;
  const World world = worldOf(judge.replay, best.hypothesis, best.values);
  const double more = ownNoiseOf(judge, world, kNoiseRuns).mean - judge.yardstick.perfect;
  return more > kNoisier * judge.yardstick.perfect_spread;
}

Candidate betterMember(const Judge& exact, const HeldOutGaps& gaps, const Candidate& pair) {
  std::vector<Candidate> members = membersOf(pair);
  for (Candidate& member : members) hearOnTotal(exact, gaps, member);
  sortByMerit(members);
  return members.front();
}

bool doesAsWellAlone(const Judge& quick, const Judge& exact, const Candidate& member, const Candidate& pair) {
  return separation(exact, pair, member) <= 0.0 && separationOnAll(quick, exact, pair, member, 0.0) <= 0.0;
}

bool SecondProofs::of(const Candidate& pair) {
  const auto more = static_cast<double>(pair.values.size()) - static_cast<double>(single_.values.size());
  if (single_.discrepancy - pair.discrepancy < Judge::kNatsPerNumber * std::max(1.0, more)) return false;
  if (pair.total_left > single_.total_left + kMaterialRest) return false;
  const World first = worldOf(exact_.replay, single_.hypothesis, single_.values);
  const World both = worldOf(exact_.replay, pair.hypothesis, pair.values);
  if (!nulls_) nulls_.emplace(nullRunsOf(exact_, first));
  const Significance second = significanceOf(exact_, pair, *nulls_);
  const double whole_way = gainWereItRight(exact_, first, both) - second.by_chance;
  return provesItself(second, causes_) && second.gain - second.by_chance >= kOfTheWay * whole_way;
}

bool earnsItsSecond(const Judge& quick, const Judge& exact, const Candidate& best, double left_by_best,
                    const Candidate& pair) {
  return isNearer(quick, exact, pair, best) && !explainsWhatAReferenceLeaves(exact, best, pair) &&
         (saysLess(pair, best) || earnsByShare(exact, best, pair) || leavesNothing(exact, best, left_by_best, pair) ||
          takesNearlyAll(best, left_by_best, pair));
}

bool earnsItsSecondByMeans(const Judge& quick, const Judge& exact, const Candidate& best, const Candidate& pair) {
  return earnsItsSecondElsewhere(quick, exact, best, pair, false);
}

bool earnsItsSecondElsewhere(const Judge& quick, const Judge& exact, const Candidate& best, const Candidate& pair,
                             bool nothing_left_there) {
  const double most_left = nothing_left_there ? 1.0 : best.total_left + kMaterialRest;
  return pair.explained > best.explained && pair.total_left < most_left && isNearer(quick, exact, pair, best) &&
         !explainsWhatAReferenceLeaves(exact, best, pair);
}

}  // namespace gap
