#include <fmt/format.h>

#include "core/text.h"
#include "gap/report/rest_wording.h"
#include "gap/report/sections.h"
#include "gap/report/titles.h"

namespace gap {

using report::Align;
using report::Html;

namespace {

void addLaws(report::Page& page, const Rest& rest) {
  if (rest.laws.empty()) return;
  std::vector<std::vector<Html>> rows;
  for (const Law& found : rest.laws) {
    const Law law = forReaders(found);
    rows.push_back({report::text(componentTitle(law.measurand, law.component)), report::code(formulaOf(law)),
                    report::text(law.unit), report::shareBar(law.explained)});
  }
  page.table(
      {{"difference", Align::Left, true}, {"measured − simulated ≈"}, {"in"}, {"follows the formula"}}, rows,
      "The shortest formulas that describe what is left, and how much of it follows them on samples that took no "
      "part in finding them. A formula is a hint where to look, not a cause. sin: it goes up and down again and again, "
      "as errors of counters, of phase measurements and of mirrors do.");
}

}  // namespace

void addRest(report::Page& page, const Diagnosis& diagnosis) {
  if (!diagnosis.rest) return;
  const Rest& rest = *diagnosis.rest;
  page.section("What is left unexplained?", "rest");
  page.lead(
      "What any cause that depends on distance, direction, surface or settings could still explain, known or not.");
  page.paragraph(restText(rest, !diagnosis.verdict.names.empty()));
  if (!hardlyAnyLeft(rest)) addLaws(page, rest);
}

}  // namespace gap
