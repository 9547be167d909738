#pragma once

#include <vector>

#include "gap/diagnosis.h"
#include "gap/fit.h"

namespace gap {

/// Shrink of the total gap on held-out samples from what it was before, without its interval.
[[nodiscard]] double shrinkOn(const Replay& replay, const World& after, const std::vector<std::size_t>& held_out,
                              double total_before, std::uint64_t seed);

/// The gap on the held-out samples before and after, with a bootstrap over samples (set-ups) and their frames.
struct BeforeAfter {
  TotalGap before;
  TotalGap after;
  Shrink shrink;
  std::map<std::string, Interval> bias_intervals;  ///< of the baseline's d_bias
};

[[nodiscard]] BeforeAfter howFar(const Replay& replay, const World& after, const std::vector<std::size_t>& held_out,
                                 std::uint64_t seed, const core::Progress& progress);

/// Jackknife over set-ups: refits the winner without each of them. [parameter order of the hypothesis] Empty with fewer
/// than two set-ups, and for offsets that belong to one set-up each.
[[nodiscard]] std::vector<Interval> parameterIntervals(const Replay& replay, const Hypothesis& hypothesis,
                                                       const std::vector<double>& values, const Evidence& evidence,
                                                       const core::Progress& progress);

}  // namespace gap
