#include <algorithm>
#include <fmt/format.h>

#include "core/text.h"
#include "gap/report/quantities.h"
#include "gap/report/sections.h"
#include "gap/report/titles.h"
#include "report/bar_figure.h"

namespace gap {

using report::Align;
using report::Html;

namespace {

/// "A", "B", … of the listed causes.
std::string letterOf(std::size_t i) { return std::string(1, static_cast<char>('A' + i)); }

const char* kindInWords(CauseKind kind) {
  switch (kind) {
    case CauseKind::kEffect:
      return "effect that the model lacks";
    case CauseKind::kParameter:
      return "wrong number";
    case CauseKind::kReference:
      return "wrong reference data";
  }
  return "";
}

Html lineBreak() { return report::rawHtml("<br/>"); }

Html numbersOf(const Cause& cause) {
  Html cell = report::text("");
  bool first = true;
  for (const FittedParameter& p : cause.parameters) {
    if (!first) cell += lineBreak();
    first = false;
    cell += report::text(fittedText(cause, p));
    std::string remark;
    if (p.recorded) remark = fmt::format("recorded {}, ", withUnit(*p.recorded, unitOf(p)));
    if (p.plausible) remark += "searched " + intervalText(*p.plausible, unitOf(p));
    if (!remark.empty())
      cell += lineBreak() + report::rawHtml("<small>") + report::text(remark) + report::rawHtml("</small>");
  }
  if (!cause.setups.empty()) {
    cell += report::text("true minus recorded, by set-up:");
    for (const auto& [setup, p] : cause.setups) {
      cell += lineBreak() +
              report::text(fmt::format("{}: {}{}", setup, p.value > 0 ? "+" : "", withUnit(p.value, unitOf(p), 2)));
    }
  }
  if (cause.parameters.empty() && cause.setups.empty()) cell += report::text("nothing to fit");
  return cell;
}

void addChart(report::Page& page, const Diagnosis& diagnosis) {
  report::BarFigure bars;
  bars.title = "By how much each cause would shrink the gap";
  bars.value_name = "per cent of the total gap on held-out samples (whisker: 90 % interval)";
  double least = 0.0;
  for (std::size_t i = 0; i < diagnosis.causes.size(); ++i) {
    const Cause& cause = diagnosis.causes[i];
    report::BarFigure::Bar bar{letterOf(i) + "  " + causeTitle(diagnosis, cause.name), 100.0 * cause.shrink.fraction,
                               report::Range{100.0 * cause.shrink.interval.low, 100.0 * cause.shrink.interval.high},
                               diagnosis.verdict.holds(cause.name), shrinkOf(cause.shrink.fraction)};
    least = std::min({least, bar.value, bar.interval->low});
    bars.bars.push_back(std::move(bar));
  }
  bars.range = report::Range{std::max(-100.0, 1.05 * least), 100.0};
  page.figure(report::barFigure(bars),
              diagnosis.verdict.names.empty()
                  ? "Each cause alone. None of them is right: a right cause would leave hardly more than noise."
              : diagnosis.verdict.holdsSeveral()
                  ? "Dark: what the answer names and corrects, both together; light: others. What a "
                    "right cause leaves is noise."
                  : "Dark: what the answer names; light: others, each alone. What a right cause "
                    "leaves is noise.");
}

void addTable(report::Page& page, const Diagnosis& diagnosis) {
  std::vector<std::vector<Html>> rows;
  for (std::size_t i = 0; i < diagnosis.causes.size(); ++i) {
    const Cause& cause = diagnosis.causes[i];
    Html name = report::text(letterOf(i) + "  ") + report::strong(causeTitle(diagnosis, cause.name));
    if (diagnosis.verdict.isNamed(cause.name)) name += report::text(" ") + report::badge("named", report::Tone::Bad);
    if (diagnosis.verdict.isBeside(cause.name))
      name += report::text(" ") + report::badge("corrected too", report::Tone::Bad);
    name += lineBreak() + report::rawHtml("<small>") + report::text(std::string(kindInWords(cause.kind)) + ": ") +
            report::code(cause.name + (cause.variant.empty() ? "" : " (" + cause.variant + ")")) +
            report::text(cause.sensors.empty() ? "" : "; sensor " + core::join(cause.sensors) + " only") +
            report::rawHtml("</small>");
    rows.push_back({name, numbersOf(cause), report::shareBar(std::max(0.0, cause.explained)),
                    report::text(shrinkOf(cause.shrink.fraction)),
                    report::text(cause.confidence < 0.005 ? "< 1 %" : percent(cause.confidence))});
  }
  page.table({{"cause", Align::Left, true},
              {"what the fit found"},
              {"explains"},
              {"gap shrinks by", Align::Right},
              {"confidence", Align::Right}},
             rows);
}

void addChains(report::Page& page, const Diagnosis& diagnosis) {
  std::vector<report::Definition> chains;
  for (std::size_t i = 0; i < diagnosis.causes.size(); ++i) {
    const Cause& cause = diagnosis.causes[i];
    if (cause.chain_titles.empty()) continue;
    Html way = report::text("");
    for (std::size_t n = 0; n < cause.chain_titles.size(); ++n) {
      if (n > 0) way += report::text(" → ");
      way += n + 1 == cause.chain_titles.size() || n == 0 ? report::strong(cause.chain_titles[n])
                                                          : report::text(cause.chain_titles[n]);
      way += report::rawHtml(" <small>") + report::text("(node " + cause.chain[n] + ")") + report::rawHtml("</small>");
    }
    chains.push_back({letterOf(i) + "  " + causeTitle(diagnosis, cause.name), "", way});
  }
  if (chains.empty()) return;
  page.subsection("From the cause to the visible error, in the cause-effect graph", "chains");
  page.paragraph(
      "The shortest way through the graph, from the cause (left) to the phenomenon that a user of the data "
      "sees (right).");
  page.block(report::definitions(chains));
}

void addConfusion(report::Page& page, const Diagnosis& diagnosis) {
  const Confusion& confusion = diagnosis.confusion;
  if (confusion.names.size() < 2) return;
  page.subsection("How easily are these causes mistaken for each other?", "confusion");
  page.paragraph(
      "Two causes that change the data in the same way cannot be told apart, however well they are fitted. "
      "1: in this experiment they look the same. 0: they differ from each other as much as they differ from "
      "the model as it is.");
  std::vector<report::TableColumn> header = {{"cause", Align::Left, true}};
  std::vector<std::vector<Html>> rows;
  for (std::size_t i = 0; i < confusion.names.size(); ++i) {
    header.push_back({letterOf(i)});
    std::vector<Html> row = {report::text(letterOf(i) + "  " + causeTitle(diagnosis, confusion.names[i]))};
    for (std::size_t j = 0; j < confusion.names.size(); ++j) {
      const double alike = confusion.alike[i][j];
      row.push_back(i == j ? report::text("–") : report::shaded(fmt::format("{:.2f}", alike), alike));
    }
    rows.push_back(std::move(row));
  }
  page.table(header, rows, "How alike each two causes are, between 0 and 1; the darker, the more alike.");
  if (diagnosis.verdict.names.empty()) return;
  std::size_t rival = 0;
  for (std::size_t j = 1; j < confusion.names.size(); ++j) {
    if (diagnosis.verdict.holds(diagnosis.causes[j].name)) continue;
    if (rival == 0 || confusion.alike[0][j] > confusion.alike[0][rival]) rival = j;
  }
  if (rival == 0) return;
  page.paragraph(fmt::format("The nearest mimic of {} is {}: it looks {} alike.",
                             causeTitle(diagnosis, confusion.names[0]), causeTitle(diagnosis, confusion.names[rival]),
                             percent(confusion.alike[0][rival])));
}

}  // namespace

void addCauses(report::Page& page, const Diagnosis& diagnosis) {
  page.section("Which cause explains it?", "causes");
  if (diagnosis.causes.empty()) {
    page.lead("Here stand the causes that would explain a part of the gap, the best first.");
    page.paragraph(diagnosis.present ? "None of the causes that were tried explains a notable part."
                                     : "There is no gap to explain, so no cause is listed.");
    return;
  }
  page.lead(fmt::format(
      "{} possible causes were tried, each with its strength fitted; here {}. “Explains” is the share of the "
      "difference, beam by beam and beyond noise, that vanishes with the cause; “shrinks” counts the pooled data with "
      "their noise, so it may say less.{}",
      diagnosis.background.hypotheses,
      diagnosis.causes.size() == 1 ? "is the only one that explains any of it" : "are the best",
      diagnosis.verdict.holdsSeveral()
          ? " Of what is named or corrected together both are said of all of it; each of the others stands alone, or "
            "beside the one of two whose partner it may replace."
          : ""));
  addChart(page, diagnosis);
  addTable(page, diagnosis);
  addConfusion(page, diagnosis);
  addChains(page, diagnosis);
}

}  // namespace gap
