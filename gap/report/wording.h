#pragma once

#include <optional>
#include <string>

#include "gap/diagnosis.h"
#include "gap/report/quantities.h"
#include "gap/which/frame_mode.h"

namespace gap {

/// One sentence for a person: what was found, how sure, how far the gap shrinks.
[[nodiscard]] std::string verdictSentence(const Diagnosis& diagnosis);

/// The same for a reader who knows neither the names of the library nor those of the files, and without numbers.
[[nodiscard]] std::string answerSentence(const Diagnosis& diagnosis);

/// "The simulated echo pulse width is 0.27 m too large at ranges from 28.1 to 69 m: 62 % of this gap, in 40 % of the
/// data."
[[nodiscard]] std::string whereSentence(const WhereRow& row);

/// The same without the shares: "The simulated echo pulse width is 0.27 m too large at ranges from 28.1 to 69 m".
[[nodiscard]] std::string whereClause(const WhereRow& row);

/// "at ranges from 28.1 to 69 m".
[[nodiscard]] std::string stratumText(const WhereRow& row);

/// "0.21 + 0.34·tan²(incidence_deg)", in the law's unit.
[[nodiscard]] std::string formulaOf(const Law& law);

/// The law that a reader is told of where no cause explains the gap; null where one does, or nothing follows a law.
[[nodiscard]] const Law* patternIn(const Verdict& verdict, const std::optional<Rest>& rest);
/// The wave that a law consists of; null for other laws.
[[nodiscard]] const Law::Term* waveIn(const Law& law);
/// The same for a reader: "The mean of the range, measured minus simulated, goes up and down by ± 0.03 m and repeats
/// every 0.9 m of distance: 95 % of what is left there."
[[nodiscard]] std::string patternText(const Law& law);

/// So little of the gap is left that nobody asks what it depends on.
[[nodiscard]] bool hardlyAnyLeft(const Rest& rest);
/// How much is left with the named cause added (or without any), and whether something systematic is in it.
[[nodiscard]] std::string restText(const Rest& rest, bool cause_is_named);

/// Where the model as it is run shows another shrink; else empty.
[[nodiscard]] std::string asRunSentence(const Diagnosis& diagnosis);
[[nodiscard]] std::string frameModeSentence(const FrameMode& mode);
[[nodiscard]] std::string nextExperimentSentence(const NextExperiment& next, const std::string& nearest_sample);

/// "echo pulse width" for "epw".
[[nodiscard]] std::string measurandTitle(const std::string& measurand);
/// "mean of the echo pulse width", "missing echoes".
[[nodiscard]] std::string componentTitle(const std::string& measurand, const std::string& component);

/// What a cause is called: "attenuation by the atmosphere", "reflectivity of the material board", "recorded position of
/// target, x (forward)".
[[nodiscard]] std::string causeTitle(const Diagnosis& diagnosis, const std::string& name);
/// What it is, in a sentence for a reader who never heard of it; empty for what is no effect of the library.
[[nodiscard]] std::string causeSummary(const std::string& name);
/// What a fitted number means: "meteorological visibility".
[[nodiscard]] std::string parameterTitle(const Cause& cause, const FittedParameter& parameter);
/// Its unit as readers know it: "°" for "deg".
[[nodiscard]] std::string unitOf(const FittedParameter& parameter);

/// Of what a verdict names, what it cannot tell from other causes: "it", or "one of them" of two.
[[nodiscard]] const char* whatIsTied(const Verdict& verdict);

/// "very sure" … "hardly more than a guess".
[[nodiscard]] std::string confidenceInWords(double confidence);
/// Whether a deviation may be chance: "no, certainly", "no", "hardly", "possibly".
[[nodiscard]] std::string certaintyInWords(double p_value);

}  // namespace gap
