#pragma once

#include <string>
#include <vector>

#include "gap/diagnosis.h"

namespace gap {

/// "a", "a and b", "a, b and c".
[[nodiscard]] std::string listOf(const std::vector<std::string>& names);

/// "Offset of the range" as it stands within a sentence; "GPS offset" stays as it is, and so do names of people.
[[nodiscard]] std::string lowerFirst(std::string text);

/// "echo pulse width" for "epw".
[[nodiscard]] std::string measurandTitle(const std::string& measurand);
/// "mean of the echo pulse width", "missing echoes".
[[nodiscard]] std::string componentTitle(const std::string& measurand, const std::string& component);

/// What a cause is called: "attenuation by the atmosphere", "reflectivity of the material board", "recorded position of
/// target, x (forward)".
[[nodiscard]] std::string causeTitle(const Diagnosis& diagnosis, const std::string& name);
/// Several of them, each with the sensors on which it holds if those are not all: "A and B".
[[nodiscard]] std::string titlesOf(const Diagnosis& diagnosis, const std::vector<std::string>& names);
/// What it is, in a sentence for a reader who never heard of it; empty for what is no effect of the library.
[[nodiscard]] std::string causeSummary(const std::string& name);
/// What a fitted number means: "meteorological visibility".
[[nodiscard]] std::string parameterTitle(const Cause& cause, const FittedParameter& parameter);
/// Its unit as readers know it: "°" for "deg".
[[nodiscard]] std::string unitOf(const FittedParameter& parameter);

/// What the verdict names, as files call it, each with the sensors on which it holds if those are not all.
[[nodiscard]] std::string namesOf(const Diagnosis& diagnosis);

}  // namespace gap
