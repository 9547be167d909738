#include "gap/wording.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "core/text.h"

namespace gap {

namespace {

std::string percent(double fraction) { return fmt::format("{:.0f} %", 100.0 * fraction); }

std::string listOf(const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, " and ")); }

/// "range-walk (sensor a only)".
std::string namesOf(const Diagnosis& diagnosis) {
  std::vector<std::string> names;
  for (const std::string& name : diagnosis.verdict.names) {
    const auto cause =
        std::find_if(diagnosis.causes.begin(), diagnosis.causes.end(), [&](const Cause& c) { return c.name == name; });
    const bool partial = cause != diagnosis.causes.end() && !cause->sensors.empty();
    names.push_back(partial ? fmt::format("{} (sensor {} only)", name, listOf(cause->sensors)) : name);
  }
  return listOf(names);
}

}  // namespace

std::string stratumText(const WhereRow& row) {
  if (row.numeric)
    return fmt::format("{} is {} to {}", row.covariate, core::significant(row.low), core::significant(row.high));
  return fmt::format("{} is {}", row.covariate, fmt::join(row.names, ", "));
}

namespace {

std::string findingSentence(const Diagnosis& diagnosis) {
  const Verdict& verdict = diagnosis.verdict;
  const std::string shrink =
      fmt::format("the gap on held-out samples shrinks by {}", percent(diagnosis.shrink.fraction));
  const std::string sure = fmt::format("(confidence {})", percent(verdict.confidence));
  std::string ties;
  if (!verdict.indistinguishable_from.empty()) {
    ties = " These data cannot tell it from " + listOf(verdict.indistinguishable_from) + ".";
  }
  switch (verdict.kind) {
    case VerdictKind::kNone:
      return "Measurement and simulation do not differ by more than their uncertainty " + sure + ".";
    case VerdictKind::kEffect:
      return fmt::format("The model lacks {}; with it {} {}.{}", namesOf(diagnosis), shrink, sure, ties);
    case VerdictKind::kParameter:
      return fmt::format("The parameter {} has a wrong value; with the fitted one {} {}.{}", listOf(verdict.names),
                         shrink, sure, ties);
    case VerdictKind::kReference:
      return fmt::format("The reference quantity {} is off; corrected, {} {}.{}", listOf(verdict.names), shrink, sure,
                         ties);
    case VerdictKind::kUnknown:
      if (diagnosis.causes.empty()) return "They differ, and nothing in the library explains it " + sure + ".";
      if (diagnosis.causes.front().shrink.fraction <= 0.0) {
        return fmt::format(
            "They differ, and nothing in the library explains it {}; with the nearest, {}, the gap on "
            "held-out samples does not shrink.",
            sure, diagnosis.causes.front().name);
      }
      return fmt::format("They differ, and nothing in the library explains it {}; the nearest, {}, explains {}.", sure,
                         diagnosis.causes.front().name, percent(std::max(0.0, diagnosis.causes.front().explained)));
  }
  return "";
}

}  // namespace

std::string verdictSentence(const Diagnosis& diagnosis) {
  const std::string finding = findingSentence(diagnosis);
  const auto& limits = diagnosis.verdict.limits;
  return limits.empty() ? finding : fmt::format("{} The data tell little: {}.", finding, fmt::join(limits, "; "));
}

std::string whereSentence(const WhereRow& row) {
  const std::string share = fmt::format("{} of this gap in {} of the data", percent(row.share), percent(row.size));
  if (row.measurand == "existence") {
    return fmt::format("{} echoes per shot {} where {} ({}).", core::significant(std::abs(row.value)),
                       row.component == "missing" ? "are missing in the measurement" : "are measured but not simulated",
                       stratumText(row), share);
  }
  const char* what = row.component == "scatter" ? (row.value > 0 ? "scatters more" : "scatters less")
                                                : (row.value > 0 ? "is larger" : "is smaller");
  return fmt::format("Measured {} {} than simulated by {} {} where {} ({}).", row.measurand, what,
                     core::significant(std::abs(row.value)), row.unit, stratumText(row), share);
}

std::string nextExperimentSentence(const NextExperiment& next, const std::string& nearest_sample) {
  std::vector<std::string> settings;
  for (const auto& [name, value] : next.parameters)
    settings.push_back(fmt::format("{} = {}", name, core::significant(value, 4)));
  return fmt::format("Repeat with {}{}: there {} and {} differ most compared to the noise.",
                     settings.empty() ? "the setting of sample " + nearest_sample : core::join(settings),
                     settings.empty() ? "" : " (as in sample " + nearest_sample + ")", next.separates[0],
                     next.separates[1]);
}

}  // namespace gap
