#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gap/diagnosis.h"
#include "gap/report/quantities.h"
#include "gap/unexplained/frame_mode.h"
#include "gap/unexplained/uneven_loss.h"
#include "gap/which/rivals.h"

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

/// Rows of `where` for a reader: of every kind of difference (measurand and component) the first one, and the same
/// along other quantities. What may be chance is among the others, unless everything may.
struct PartedRows {
  std::vector<WhereRow> first, others;
};
[[nodiscard]] PartedRows partedByKind(const std::vector<WhereRow>& rows);

/// "at ranges from 28.1 to 69 m".
[[nodiscard]] std::string stratumText(const WhereRow& row);

/// Where the model as it is run shows another shrink, or a much larger gap; else empty.
[[nodiscard]] std::string asRunSentence(const Diagnosis& diagnosis);
/// Which numbers of what is named came out at the end of what was searched; empty if none did.
[[nodiscard]] std::string atEndSentence(const Diagnosis& diagnosis);
/// Which numbers may be wrong in place of which of the two effects that are named, a sentence for each effect.
[[nodiscard]] std::vector<std::string> recalibrationSentences(const Diagnosis& diagnosis,
                                                              const std::vector<Rival>& numbers);
/// What contradicts every cause that was tried, in words.
struct ContradictionWords {
  const char* in;        ///< where measurement and simulation differ
  const char* what;      ///< what the data show there
  const char* why_not;   ///< why the nearest cause is not it
  const char* look_for;  ///< the next step, a sentence
};
/// Nothing where nothing does.
[[nodiscard]] std::optional<ContradictionWords> wordsFor(Contradiction contradiction);
[[nodiscard]] std::string frameModeSentence(const FrameMode& mode);
[[nodiscard]] std::string unevenLossSentence(const UnevenLoss& loss);
[[nodiscard]] std::string nextExperimentSentence(const NextExperiment& next);

/// Whether a verdict is that it is its cause or one other, which cannot be told apart: its confidence is that in both
/// together (verdict.h).
[[nodiscard]] bool isOneOfTwo(const Verdict& verdict);

/// Of such a verdict the other cause, if it says something else of the model (an effect, a number, the reference); null
/// if it does not, or for any other verdict.
[[nodiscard]] const Cause* otherOfTwo(const Diagnosis& diagnosis);

/// Of what a verdict names, what it cannot tell from other causes: "it", or "one of them" of two.
[[nodiscard]] const char* whatIsTied(const Verdict& verdict);

/// "very sure" … "hardly more than a guess".
[[nodiscard]] std::string confidenceInWords(double confidence);
/// Whether a deviation may be chance: "no, certainly", "no", "hardly", "possibly".
[[nodiscard]] std::string certaintyInWords(double p_value);

}  // namespace gap
