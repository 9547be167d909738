#include "gap/which/whole_gap.h"

#include <algorithm>

namespace gap {

namespace {

constexpr double kMostBesideNoise = 0.5;  // of the total gap

Shrink shrinkBy(const Judge& exact, const HeldOutGaps& gaps, const Candidate& candidate,
                const core::Progress& progress) {
  return gaps.with(worldOf(exact.replay, candidate.hypothesis, candidate.values), progress).shrink;
}

}  // namespace

double restOfWholeGap(const HeldOutGaps& gaps, const Candidate& candidate) {
  return gaps.aboveNoise() * candidate.total_left;
}

bool holdsOnTotal(const Candidate& winner, double shrink) {
  return shrink > 0.0 || winner.explained >= kNearlyAllCells || winner.total_left < kMostBesideNoise;
}

void leadOnTotal(const Judge& exact, const HeldOutGaps& gaps, double enough, std::vector<Candidate>& singles,
                 const core::Progress& progress) {
  if (holdsOnTotal(singles.front(), shrinkBy(exact, gaps, singles.front(), progress).fraction)) return;
  const auto holds = std::find_if(singles.begin() + 1, singles.end(), [&](const Candidate& candidate) {
    return exact.accountedFor(candidate) >= enough && shrinkBy(exact, gaps, candidate, progress).interval.low > 0.0;
  });
  if (holds != singles.end()) std::rotate(singles.begin(), holds, holds + 1);
}

}  // namespace gap
