#include "gap/report/rest_wording.h"

#include <cmath>
#include <fmt/format.h>

#include "core/text.h"
#include "gap/report/quantities.h"
#include "gap/report/titles.h"

namespace gap {

namespace {

/// A term without its coefficient: "·tan²(incidence_deg)", "/range_m", "·sin(2π·(range_m − 0.2)/0.9)".
std::string functionOf(const Law::Term& term) {
  if (term.function == "sin x")
    return fmt::format("·sin(2π·({} − {})/{})", term.covariate, core::significant(term.zero, 4),
                       core::significant(term.period));
  const bool named_function = term.function.find(' ') != std::string::npos;
  std::string of_x = term.function == "1/x" ? "/x" : "·" + term.function;
  std::erase(of_x, ' ');
  return of_x.replace(of_x.find('x'), 1, named_function ? "(" + term.covariate + ")" : term.covariate);
}

}  // namespace

std::string formulaOf(const Law& law) {
  std::string formula = core::significant(law.constant);
  for (const Law::Term& term : law.terms) {
    formula += fmt::format(" {} {}{}", term.coefficient < 0.0 ? "−" : "+",
                           core::significant(std::abs(term.coefficient)), functionOf(term));
  }
  return formula;
}

Law forReaders(Law law) {
  if (!law.relative) return law;
  law.relative = false;
  law.unit = "% of the received power";
  law.constant *= 100.0;
  for (Law::Term& term : law.terms) term.coefficient *= 100.0;
  return law;
}

const Law* patternIn(const Verdict& verdict, const std::optional<Rest>& rest) {
  const bool told = verdict.kind == VerdictKind::kUnknown && rest && !rest->laws.empty();
  return told ? &rest->laws.front() : nullptr;
}

const Law::Term* waveIn(const Law& law) {
  return law.terms.size() == 1 && law.terms.front().period > 0.0 ? &law.terms.front() : nullptr;
}

std::string patternText(const Law& found) {
  const Law law = forReaders(found);
  const Law::Term* wave = waveIn(law);
  const bool range = wave && wave->covariate == "range_m";
  const std::string how =
      wave ? fmt::format("goes up and down by ± {} and repeats every {} of {}", withUnit(wave->coefficient, law.unit),
                         withUnit(wave->period, range ? "m" : "°"), range ? "distance" : "azimuth")
           : "follows " + (law.unit.empty() ? formulaOf(law) : fmt::format("({}) {}", formulaOf(law), law.unit));
  return fmt::format("The {}, measured minus simulated, {}: {} of what is left there.",
                     componentTitle(law.measurand, law.component), how, percent(law.explained));
}

bool hardlyAnyLeft(const Rest& rest) {
  constexpr double kLittle = 0.05;  // of the gap
  return rest.left < kLittle;
}

std::string restText(const Rest& rest, bool cause_is_named) {
  constexpr double kRegular = 0.5;      // of the rest: more depends on something than does not
  constexpr double kAccidental = 0.15;  // of the rest: hardly any of it depends on anything
  const std::string left =
      cause_is_named ? fmt::format(
                           "With the named cause added, {} of the differences are left, beam by beam on held-out "
                           "samples. ",
                           percent(rest.left))
                     : "No cause was added, so all differences are left. ";
  if (hardlyAnyLeft(rest)) return left + "So little is left that nothing is sought in it.";
  const std::string share = percent(rest.systematic);
  if (rest.systematic <= kAccidental)
    return left +
           fmt::format(
               "Of what is left, only {} follows distance, direction, surface or settings; the rest is scattered, or "
               "changes quickly with one of them.",
               share);
  return left + fmt::format("{} of what is left follows distance, direction, surface and settings in a regular way{}",
                            share, rest.systematic >= kRegular ? ": something systematic is still missing." : ".");
}

}  // namespace gap
