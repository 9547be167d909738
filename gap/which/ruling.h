#pragma once

#include <cstdint>
#include <vector>

#include "gap/which/ablation.h"
#include "gap/which/decision.h"

namespace gap {

/// Who judges, and whether there is anything to judge.
struct FirstLook {
  Judge judge;
  double p_value = 1.0;  ///< of so large a gap by chance
};

/// Samples judge; or every second beam of all samples, if the gap shows in held-out samples only, or in the
/// others only. It is there then, however much the beams of all samples hide it.
[[nodiscard]] FirstLook judgeOf(const Replay& replay, std::uint64_t seed, const Ablation& without);

/// What was decided, and who judged.
struct Ruling {
  Judge quick, exact;
  Decision decision;
};

/// Decides; where what the best cause alone leaves shows in held-out samples only, or in the others only, a second one
/// acts there of which the samples that are fitted cannot tell enough: then beams of all samples decide, if they name
/// anything. So it is where another cause or pair that was tried is far nearer to the fitted samples than what is
/// named; and where nothing is named though the gap is mostly in one part of the samples, if they explain nearly all of
/// it. `clear`: the gap is beyond doubt; where it is not, edges prove nothing, for a millimetre decides whether a
/// beam still grazes a bright surface, or the number of rays, and a faint halo explains the few echoes that only one
/// program has.
[[nodiscard]] Ruling ruleOn(const Judge& quick, const Judge& exact, const HeldOutGaps& gaps, bool clear,
                            const WhereResult& where, const std::vector<Hypothesis>& hypotheses,
                            const Ablation& without, core::Progress& progress);

}  // namespace gap
