#pragma once

#include <span>
#include <vector>

#include "metrics/distributions/interval.h"
#include "metrics/distributions/p_box.h"

namespace metrics {

/// From simulated outputs to a p-box, when some inputs scatter (aleatory) and others are only known to a range
/// (epistemic). Two loops, and it matters which one is outside:
///
///   E-outer   for each epistemic choice, one EDF over the aleatory samples; then PBox::envelope of these EDFs.
///             The unknown is one constant, the same for all samples of a run (an alignment, a calibration).
///   A-outer   for each aleatory sample, smallest and largest output over the epistemic choices; then their EDFs.
///             The unknown may differ from sample to sample (a reflectance, a resolution error).
///
/// From the same table of outputs the A-outer box always contains the E-outer box. They are equal where the same
/// choice makes every output smallest and the same makes every one largest, as in y = a + e. In y = a e with a and e
/// both +-1 they differ most: every E-outer EDF is {-1, 1} and the box has no width, A-outer it is [-1, 1].
/// Both are inner estimates of the true box if the choices do not include the extremes of the epistemic range.
/// Source: Roy & Oberkampf 2011, doi:10.1016/j.cma.2011.03.016 (nested sampling).

/// A-outer. outputs[i] holds the outputs of aleatory sample i, one for each epistemic choice, in any order; the numbers
/// of choices may differ. Throws InputError if there is no sample, a sample has no output, or one is not finite.
[[nodiscard]] PBox aleatoryOuter(std::span<const std::vector<double>> outputs);

/// Box of a sample whose values are each known to an interval: EDF of the low ends, EDF of the high ends.
/// Throws InputError if there is none, ends are exchanged or not finite.
/// Source: Ferson et al. 2007, SAND2007-0939.
[[nodiscard]] PBox fromIntervals(std::span<const Interval> values);

/// What a value may be below and above what was read; both >= 0. [unit of the measurand]
struct Margin {
  double below;
  double above;
};

/// The box moved apart: its left edge by `below` to the left, its right edge by `above` to the right. Of an EDF: the
/// EDF +- w. Throws InputError if a margin is negative or not finite.
[[nodiscard]] PBox widened(const PBox& box, const Margin& margin);

}  // namespace metrics
