#pragma once

#include <memory>

#include "gap/candidates/candidates.h"
#include "gap/far/how_far.h"
#include "gap/where/where.h"

namespace gap {

/// A judge by as few beams as another one, but of every sample half of them are those that deviate most in a world.
struct CloseJudge {
  Replay replay;
  Judge judge;

  /// `deviating`: the residuals of that world, by all beams.
  CloseJudge(const Judge& quick, const Judge& exact, const WhereResult& deviating);
};

/// For the causes beside the best one, where that leaves a gap beyond doubt by all beams, and by the few far less than
/// so few would show of what is in all of them: then something else is at work in beams that are not among the few (a
/// false target in one column). Else nothing. `left_by_best`: its deviationsLeft, by all beams.
[[nodiscard]] std::unique_ptr<const CloseJudge> closeJudgeBeside(const Judge& quick, const Judge& exact,
                                                                 const Candidate& best, double left_by_best);

/// Where no cause explains half of a gap that is beyond doubt, it may lie in beams that are not among the few with
/// which causes are chosen (echoes that merge on one side of one car). So all are searched once more on the beams that
/// deviate most, and as many others, and those that come nearest there and nearer by all beams than before take their
/// places. `singles` stay best first. Does nothing where every beam took part before.
void lookCloser(const Judge& quick, const Judge& exact, const HeldOutGaps& gaps, const WhereResult& where,
                std::vector<Candidate>& singles, core::Progress& progress);

}  // namespace gap
