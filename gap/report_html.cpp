#include "gap/report_html.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "core/text.h"
#include "core/version.h"
#include "gap/wording.h"
#include "metrics/distributions/edf.h"
#include "report/bar_figure.h"
#include "report/edf_figure.h"
#include "report/map_figure.h"
#include "report/page.h"

namespace gap {

namespace {

using report::Align;
using report::Html;
using report::Tone;

std::string percent(double fraction) { return fmt::format("{:.0f} %", 100.0 * fraction); }

std::string intervalText(const Interval& interval) {
  return fmt::format("{} to {}", core::significant(interval.low), core::significant(interval.high));
}

Tone toneOf(VerdictKind kind) {
  if (kind == VerdictKind::kNone) return Tone::Good;
  return kind == VerdictKind::kUnknown ? Tone::Warning : Tone::Bad;
}

void addVerdict(report::Page& page, const Diagnosis& diagnosis) {
  page.section("Verdict", "verdict", report::badge(toString(diagnosis.verdict.kind), toneOf(diagnosis.verdict.kind)));
  page.paragraph(report::strong(diagnosis.verdict.text));
  if (diagnosis.approximation) page.paragraph(diagnosis.approximation->text);
  for (const std::string& note : diagnosis.notes) page.paragraph(note);
  std::vector<report::KeyValue> rows = {
      {"experiment", report::text(diagnosis.experiment)},
      {"model", report::text(diagnosis.model)},
      {"held-out samples", report::text(core::join(diagnosis.held_out))},
      {"p-value of a gap being there",
       report::text(diagnosis.p_value < 1e-12 ? "< 1e-12" : core::significant(diagnosis.p_value))},
      {"total gap on the held-out samples",
       report::text(core::significant(diagnosis.before.total) + " resolution steps")}};
  page.keyValues(rows);
  if (diagnosis.weak_hold_out) {
    page.paragraph(
        "No whole sample could be held out: beams of the same samples were fitted and judged. Treat the "
        "result with reserve and record further set-ups.");
  }
}

void addWhere(report::Page& page, const Diagnosis& diagnosis) {
  page.section("Where", "where");
  if (!diagnosis.present || diagnosis.where.empty()) {
    page.paragraph("No stratum deviates by more than its uncertainty.");
    return;
  }
  page.paragraph(whereSentence(diagnosis.where.front()));
  std::vector<std::vector<Html>> rows;
  for (const WhereRow& row : diagnosis.where) {
    if (rows.size() >= 12) break;
    rows.push_back({report::text(row.measurand), report::text(row.component), report::text(stratumText(row)),
                    report::text(core::significant(row.value) + " " + row.unit), report::text(percent(row.share)),
                    report::text(percent(row.size)),
                    report::text(row.p_value < 1e-12 ? "< 1e-12" : core::significant(row.p_value, 2))});
  }
  page.table({{"measurand"},
              {"component"},
              {"stratum"},
              {"measured − simulated", Align::Right},
              {"share of gap", Align::Right},
              {"share of data", Align::Right},
              {"p", Align::Right}},
             rows);
  for (const ResidualMap& map : diagnosis.maps) {
    report::MapFigure figure;
    figure.title = fmt::format("{} in sample {}", map.measurand, map.sample);
    figure.x_name = "azimuth in °";
    figure.y_name = "layer";
    figure.value_name = fmt::format("measured − simulated in {}", map.unit);
    figure.cell_width = map.azimuth_step_deg;
    figure.x_grows_leftwards = true;
    for (const ResidualMap::Point& p : map.points) figure.cells.push_back({p.azimuth_deg, p.layer, p.value});
    page.figure(report::mapFigure(figure),
                fmt::format("Mean over the frames of each beam: {}, sample {}.", map.measurand, map.sample));
  }
}

void addCauses(report::Page& page, const Diagnosis& diagnosis) {
  page.section("Which cause", "causes");
  if (diagnosis.causes.empty()) {
    page.paragraph(diagnosis.present ? "No hypothesis of the library explains a notable part." : "Nothing to explain.");
    return;
  }
  report::BarFigure bars;
  bars.title = "Share of the explainable discrepancy on held-out data";
  bars.value_name = "share";
  bars.range = report::Range{0.0, 1.0};
  std::vector<std::vector<Html>> rows;
  for (const Cause& cause : diagnosis.causes) {
    const bool named = std::find(diagnosis.verdict.names.begin(), diagnosis.verdict.names.end(), cause.name) !=
                       diagnosis.verdict.names.end();
    bars.bars.push_back({cause.name, std::clamp(cause.explained, 0.0, 1.0), std::nullopt, named});
    std::string parameters;
    for (const FittedParameter& p : cause.parameters) {
      parameters +=
          fmt::format("{}{} = {}{}{}{}", parameters.empty() ? "" : "; ", p.name, core::significant(p.value, 4),
                      p.unit.empty() ? "" : " ", p.unit, p.interval ? " (" + intervalText(*p.interval) + ")" : "");
    }
    for (const auto& [setup, p] : cause.setups) {
      parameters +=
          fmt::format("{}{}: {} {}", parameters.empty() ? "" : "; ", setup, core::significant(p.value, 3), p.unit);
    }
    rows.push_back({report::text(toString(cause.kind)), report::text(cause.name), report::text(cause.variant),
                    report::text(parameters), report::text(percent(cause.explained)),
                    report::text(percent(cause.shrink.fraction)), report::text(percent(cause.confidence)),
                    report::text(core::join(cause.chain_titles, " → "))});
  }
  page.figure(report::barFigure(bars),
              "A cause that is right explains nearly all; the rest of the list is what it was weighed against.");
  page.table({{"kind"},
              {"cause"},
              {"form"},
              {"fitted parameters (95 % interval over set-ups)"},
              {"explains", Align::Right},
              {"gap shrinks by", Align::Right},
              {"confidence", Align::Right},
              {"in the cause-effect graph"}},
             rows);
  if (!diagnosis.verdict.indistinguishable_from.empty()) {
    page.paragraph("These data cannot tell it from: " + core::join(diagnosis.verdict.indistinguishable_from) + ".");
  }
  if (diagnosis.next_experiment) page.paragraph("Next experiment. " + diagnosis.next_experiment->text);
}

void addHowFar(report::Page& page, const Diagnosis& diagnosis) {
  page.section("How far the gap shrinks", "shrink");
  if (!diagnosis.after) {
    page.paragraph("No cause was added, so nothing was re-simulated.");
  } else {
    page.paragraph(
        fmt::format("Total gap on held-out samples: {} before, {} after: it shrinks by {} (95 % interval {}).",
                    core::significant(diagnosis.before.total), core::significant(diagnosis.after->total),
                    percent(diagnosis.shrink.fraction), intervalText(diagnosis.shrink.interval)));
    std::vector<std::vector<Html>> rows;
    for (const MeasurandGap& before : diagnosis.before.measurands) {
      for (const MeasurandGap& after : diagnosis.after->measurands) {
        if (after.name != before.name) continue;
        rows.push_back({report::text(before.name), report::text(core::significant(before.d_bias)),
                        report::text(core::significant(after.d_bias)), report::text(core::significant(before.d_cavm)),
                        report::text(core::significant(after.d_cavm)), report::text(before.unit)});
      }
    }
    page.table({{"measurand"},
                {"d_bias before", Align::Right},
                {"after", Align::Right},
                {"d_CAVM before", Align::Right},
                {"after", Align::Right},
                {"unit"}},
               rows);
    page.paragraph("d_bias is positive when the simulation is too high.");
  }
  for (const BeforeAfterValues& values : diagnosis.curves) {
    const metrics::PBox measured{metrics::Edf(values.measured)};
    const auto figure = [&](const std::vector<double>& simulated, const char* when) {
      const metrics::PBox box{metrics::Edf(simulated)};
      page.figure(report::edfFigure({.simulated = box, .measured = measured},
                                    {.title = fmt::format("{}, sample {}, {}", values.measurand, values.sample, when),
                                     .quantity = values.measurand,
                                     .unit = values.unit,
                                     .simulated_n = {simulated.size()}}));
    };
    figure(values.before, "model as it is");
    if (!values.after.empty()) figure(values.after, "with the cause added");
  }
}

}  // namespace

std::string reportHtml(const Diagnosis& diagnosis) {
  report::Page page("Diagnosis of the sim-to-real gap", diagnosis.experiment + " against " + diagnosis.model);
  if (diagnosis.synthetic) {
    page.banner("Synthetic data: the measurement was made by a program, no real sensor measured it.", Tone::Warning);
  }
  addVerdict(page, diagnosis);
  addWhere(page, diagnosis);
  addCauses(page, diagnosis);
  addHowFar(page, diagnosis);
  page.section("How this was found", "method");
  page.paragraph(
      "Every hypothesis was fitted on the other samples and judged on the held-out ones, with the same random "
      "numbers for all. Confidences are not yet calibrated on withheld cases.");
  page.keyValues({{"fidelis", report::text(core::kVersion)}});
  return page.html();
}

}  // namespace gap
