#pragma once

#include <vector>

#include "gap/diagnosis.h"
#include "gap/fit.h"

namespace gap {

/// Mean total gap of a world over some samples.
[[nodiscard]] double totalOf(const Replay& replay, const World& world, const std::vector<std::size_t>& samples,
                             std::uint64_t seed);

/// The same if the world were right: between two simulations of it.
[[nodiscard]] double selfTotalOf(const Replay& replay, const World& world, const std::vector<std::size_t>& samples,
                                 std::uint64_t seed);

/// Shrink of the total gap from what it was before.
[[nodiscard]] double shrinkOf(double before, double after);

/// The gap on the held-out samples before and after, with a bootstrap over samples (set-ups) and their frames.
struct BeforeAfter {
  TotalGap before;
  TotalGap after;
  Shrink shrink;
  std::map<std::string, Interval> bias_intervals;  ///< of the baseline's d_bias
  std::vector<SampleTotals> samples;
};

[[nodiscard]] BeforeAfter howFar(const Replay& replay, const World& after, const std::vector<std::size_t>& held_out,
                                 std::uint64_t seed, const core::Progress& progress);

/// Jackknife over set-ups: refits the winner without each of them. [parameter order of the hypothesis] Empty with fewer
/// than two set-ups, and for offsets that belong to one set-up each.
[[nodiscard]] std::vector<Interval> parameterIntervals(const Replay& replay, const Hypothesis& hypothesis,
                                                       const std::vector<double>& values, const Evidence& evidence,
                                                       const core::Progress& progress);

}  // namespace gap
