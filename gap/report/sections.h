#pragma once

#include <string>

#include "gap/diagnosis.h"
#include "report/page.h"

namespace gap {

/// The parts of the page, in its order. Each begins with a sentence that says what it shows and how to read it, and
/// stands by itself for every kind of verdict.
void addAnswer(report::Page& page, const Diagnosis& diagnosis);  ///< what, how sure, how far, what to do next
void addWhere(report::Page& page, const Diagnosis& diagnosis);
void addCauses(report::Page& page, const Diagnosis& diagnosis);
void addRest(report::Page& page, const Diagnosis& diagnosis);
void addHowFar(report::Page& page, const Diagnosis& diagnosis);
void addNext(report::Page& page, const Diagnosis& diagnosis);
void addMethod(report::Page& page, const Diagnosis& diagnosis);  ///< and the words used

/// "meteorological visibility 522 m (95 % interval 450 to 594 m)".
[[nodiscard]] std::string fittedText(const Cause& cause, const FittedParameter& parameter);

}  // namespace gap
