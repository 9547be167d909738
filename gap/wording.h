#pragma once

#include <string>

#include "gap/diagnosis.h"

namespace gap {

/// One sentence for a person: what was found, how sure, how far the gap shrinks.
[[nodiscard]] std::string verdictSentence(const Diagnosis& diagnosis);

/// "Measured echo pulse widths are 0.27 m narrower than simulated where range_m is 28.1 to 69.0 (62 % of this gap)."
[[nodiscard]] std::string whereSentence(const WhereRow& row);

/// "range_m is 28.1 to 69.0".
[[nodiscard]] std::string stratumText(const WhereRow& row);

[[nodiscard]] std::string nextExperimentSentence(const NextExperiment& next, const std::string& nearest_sample);

}  // namespace gap
