#include <fmt/format.h>

#include "core/text.h"
#include "gap/report/sections.h"
#include "gap/report/wording.h"

namespace gap {

using report::Align;
using report::Html;

namespace {

constexpr double kLittle = 0.05;      // of the gap left: nobody asks what it depends on
constexpr double kRegular = 0.5;      // of the rest: more depends on something than does not
constexpr double kAccidental = 0.15;  // of the rest: hardly any of it depends on anything

/// Whether the rest is a hint that something is still missing.
std::string meaningOf(const Rest& rest) {
  if (rest.left < kLittle) return "So little is left that nothing is sought in it.";
  const std::string share = percent(rest.systematic);
  if (rest.systematic >= kRegular)
    return fmt::format(
        "{} of what is left follows distance, direction, surface and settings in a regular way: something systematic "
        "is "
        "still missing.",
        share);
  if (rest.systematic <= kAccidental)
    return fmt::format(
        "Of what is left, {} follows distance, direction, surface or settings smoothly: it is scattered, or changes "
        "quickly with one of them.",
        share);
  return fmt::format("{} of what is left follows distance, direction, surface and settings in a regular way.", share);
}

void addLaws(report::Page& page, const Rest& rest) {
  if (rest.laws.empty()) return;
  std::vector<std::vector<Html>> rows;
  for (const Law& law : rest.laws) {
    rows.push_back({report::text(componentTitle(law.measurand, law.component)), report::code(formulaOf(law)),
                    report::text(law.unit), report::shareBar(law.explained)});
  }
  page.table(
      {{"difference", Align::Left, true}, {"measured − simulated ≈"}, {"in"}, {"follows the formula"}}, rows,
      "The shortest formulas that describe what is left, and how much of it follows them on samples that took no "
      "part in finding them. A formula is a hint where to look, not a cause.");
}

}  // namespace

void addRest(report::Page& page, const Diagnosis& diagnosis) {
  if (!diagnosis.rest) return;
  const Rest& rest = *diagnosis.rest;
  page.section("What is left unexplained?", "rest");
  page.lead(
      "What any cause that depends on distance, direction, surface or settings could still explain, known or not.");
  const std::string left =
      diagnosis.verdict.names.empty()
          ? std::string("No cause was added, so all differences are left.")
          : fmt::format("With the named cause added, {} of the differences are left, beam by beam on held-out samples.",
                        percent(rest.left));
  page.paragraph(left + " " + meaningOf(rest));
  if (rest.left >= kLittle) addLaws(page, rest);
}

}  // namespace gap
