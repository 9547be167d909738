#include "gap/candidates/whole_gap.h"

#include <algorithm>

namespace gap {

namespace {

constexpr double kMostBesideNoise = 0.5;  // of the total gap

}  // namespace

void hearOnTotal(const Judge& judge, const HeldOutGaps& gaps, Candidate& candidate) {
  candidate.total_left = gaps.leftIn(worldOf(judge.replay, candidate.hypothesis, candidate.values));
  judge.hear(candidate);
}

double restOfWholeGap(const HeldOutGaps& gaps, const Candidate& candidate) {
  return gaps.aboveNoise() * candidate.total_left;
}

bool holdsOnTotal(const Candidate& winner, double shrink) {
  return shrink > 0.0 || winner.explained >= kNearlyAllCells || winner.total_left < kMostBesideNoise;
}

void leadOnTotal(const Judge& exact, const HeldOutGaps& gaps, double enough, std::vector<Candidate>& singles,
                 const core::Progress& progress) {
  const auto worldWith = [&](const Candidate& c) { return worldOf(exact.replay, c.hypothesis, c.values); };
  if (holdsOnTotal(singles.front(), gaps.shrinkTo(gaps.totalIn(worldWith(singles.front()))))) return;
  const auto holds = std::find_if(singles.begin() + 1, singles.end(), [&](const Candidate& candidate) {
    return exact.accountedFor(candidate) >= enough &&
           gaps.with(worldWith(candidate), progress).shrink.interval.low > 0.0;
  });
  if (holds != singles.end()) std::rotate(singles.begin(), holds, holds + 1);
}

}  // namespace gap
