#pragma once

#include <string>
#include <vector>

#include "gap/causes/split.h"

namespace gap {

// Data that can be diagnosed, but tell little.

/// Where most detections lie where the scene has no surface, the scene or the profile may be another's, unless the
/// named cause makes these echoes, as fog and rain do.
enum class Stray { kUnexplained, kExplained };

/// Why the data are too few to be sure of anything, a clause each ("there is one sample only …"); empty if they are
/// not.
[[nodiscard]] std::vector<std::string> limitsOf(const Replay& replay, const Split& split, Stray stray);

/// The most that a verdict from data with so many limits may be believed, whatever else speaks for it: a half with one,
/// less with each further one. A choice, not a calibration: below 0.5 nobody takes a cause for found.
[[nodiscard]] double mostConfidence(std::size_t limits);

/// What a person should know of the data, whatever the verdict: measurands left out, empty samples, detections where
/// the scene has nothing, roles that could not be kept. Sentences.
[[nodiscard]] std::vector<std::string> notesOn(const Replay& replay, Stray stray);

}  // namespace gap
