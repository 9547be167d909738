#pragma once

#include "gap/causes/hypotheses.h"

namespace gap {

/// What the measured values themselves say of a coarse counter, in the hypothesis that there is one:
///
/// - the step of the range, more exactly than any fit: means of few noisy frames hardly show it. Where the values are
///   too few (a wall a set-up), the search begins at the step that they suggest: no other one of those it tries may
///   fit. Of several sensors each has its own;
/// - whether the output was rounded to the profile's resolution after it was counted (formats.md section 3, step 6).
///   Values that are no multiples of that were not: then the sensor's resolution is none in the world of this
///   hypothesis.
void readCounter(const Replay& replay, Hypothesis& hypothesis);

}  // namespace gap
