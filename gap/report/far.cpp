#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "core/text.h"
#include "gap/report/quantities.h"
#include "gap/report/sections.h"
#include "gap/report/titles.h"
#include "report/curve_figure.h"
#include "report/figure.h"

namespace gap {

using report::Align;
using report::Html;

namespace {

double largestOf(const MeasurandGap& before, const MeasurandGap* after) {
  const double was = std::max(std::abs(before.d_bias), std::abs(before.d_cavm));
  return after ? std::max({was, std::abs(after->d_bias), std::abs(after->d_cavm)}) : was;
}

void addNumbers(report::Page& page, const Diagnosis& diagnosis) {
  std::vector<std::vector<Html>> rows;
  for (const MeasurandGap& before : diagnosis.before.measurands) {
    const MeasurandGap* after = nullptr;
    if (diagnosis.after) {
      for (const MeasurandGap& m : diagnosis.after->measurands) after = m.name == before.name ? &m : after;
    }
    const auto interval = diagnosis.bias_intervals.find(before.name);
    const double largest = largestOf(before, after);
    const auto number = [&](double value) { return withUnitOf(largest, value, before.unit, 2); };
    std::string bias = number(before.d_bias);
    if (interval != diagnosis.bias_intervals.end())
      bias += " (" + intervalText(interval->second, before.unit, largest) + ")";
    rows.push_back({report::text(measurandTitle(before.name)), report::text(bias),
                    report::text(after ? number(after->d_bias) : "–"), report::text(number(before.d_cavm)),
                    report::text(after ? number(after->d_cavm) : "–")});
  }
  const auto share = [&](double TotalGap::*member, const char* name) {
    constexpr double kShown = 0.0005;
    if (diagnosis.before.*member <= kShown && (!diagnosis.after || (*diagnosis.after).*member <= kShown)) return;
    rows.push_back({report::text(name), report::text(percent(diagnosis.before.*member)),
                    report::text(diagnosis.after ? percent((*diagnosis.after).*member) : "–"), report::text("–"),
                    report::text("–")});
  };
  share(&TotalGap::missing_fraction, "missing echoes (share)");
  share(&TotalGap::extra_fraction, "extra echoes (share)");
  page.table(
      {{"measurand", Align::Left, true},
       {"bias before (95 % interval)", Align::Right},
       {"bias after", Align::Right},
       {"scatter error before", Align::Right},
       {"scatter error after", Align::Right}},
      rows,
      std::string("Means over these samples, all detections of a sample together. Bias > 0: the simulation is too "
                  "high.") +
          (diagnosis.after ? " A measurand in which little was wrong may get a little worse: the causes were "
                             "fitted to all measurands at once."
                           : ""));
}

/// Cumulative share of sorted values below x.
std::vector<double> curveOf(std::vector<double> values, const std::vector<double>& x) {
  std::sort(values.begin(), values.end());
  std::vector<double> y;
  for (const double at : x) {
    const auto below = std::upper_bound(values.begin(), values.end(), at) - values.begin();
    y.push_back(static_cast<double>(below) / static_cast<double>(values.size()));
  }
  return y;
}

report::Range rangeOf(const BeforeAfterValues& values) {
  constexpr double kTail = 0.002;  // a few outliers must not squeeze the curves
  report::Range range = {1e300, -1e300};
  for (const auto* list : {&values.measured, &values.before, &values.after}) {
    if (list->empty()) continue;
    std::vector<double> sorted = *list;
    std::sort(sorted.begin(), sorted.end());
    const auto tail = static_cast<std::size_t>(kTail * static_cast<double>(sorted.size()));
    range.low = std::min(range.low, sorted[tail]);
    range.high = std::max(range.high, sorted[sorted.size() - 1 - tail]);
  }
  return report::widened(range, 0.05);
}

void addCurves(report::Page& page, const BeforeAfterValues& values) {
  constexpr std::size_t kPoints = 600;
  const report::Range range = rangeOf(values);
  report::CurveFigure figure;
  const std::string title = measurandTitle(values.measurand);
  const ReadableUnit shown = readableUnit(std::max(std::abs(range.low), std::abs(range.high)), values.unit);
  figure.title = fmt::format("Distribution of the {}, sample {}", title, values.sample);
  figure.x_name = fmt::format("{} in {}", title, shown.unit);
  figure.y_name = "share of the values below";
  figure.y_range = report::Range{0.0, 1.0};
  for (std::size_t i = 0; i < kPoints; ++i)
    figure.x.push_back(range.low + (range.high - range.low) * static_cast<double>(i) / (kPoints - 1));
  const auto add = [&](const char* name, const std::vector<double>& list, const char* colour, const char* dashes) {
    if (list.empty()) return;
    figure.curves.push_back(
        {fmt::format("{} ({} values)", name, list.size()), curveOf(list, figure.x), colour, dashes});
  };
  add("model as it is", values.before, "#d55e00", "7 4");
  add("with the cause added", values.after, "#0072b2", "");
  add("measured", values.measured, "#1f2328", "2 3");
  for (double& x : figure.x) x *= shown.per_unit;
  page.figure(report::curveFigure(figure),
              values.after.empty()
                  ? "The nearer the simulated curve lies to the measured one, the better the simulation; the area "
                    "between them is the error."
                  : "The nearer a curve lies to the measured one (black, dotted), the better; the area between them is "
                    "the error.");
}

void addAcceptance(report::Page& page, const Diagnosis& diagnosis) {
  page.subsection("Acceptance tests whose verdict changes", "acceptance");
  if (!diagnosis.acceptance_tests) {
    page.paragraph(report::text("Not part of this run. ") + report::code("fidelis gap … --project FILE") +
                   report::text(" judges the proposed model with the acceptance tests of a project."));
    return;
  }
  const auto& tests = *diagnosis.acceptance_tests;
  const auto flips = std::count_if(tests.begin(), tests.end(), [](const TwiceJudgedTest& t) { return t.flips(); });
  page.paragraph(
      fmt::format("{} of {} acceptance tests of the project judge the proposed model otherwise.", flips, tests.size()));
  if (flips == 0) return;
  const auto verdict = [](const std::string& word) {
    return report::badge(word, word == "passed" ? report::Tone::Good : report::Tone::Bad);
  };
  std::vector<std::vector<Html>> rows;
  for (const TwiceJudgedTest& test : tests) {
    if (!test.flips()) continue;
    rows.push_back({report::text(test.id + " " + test.title), verdict(test.before), verdict(test.after),
                    report::text(test.text_after)});
  }
  page.table({{"test", Align::Left, true}, {"model as it is"}, {"with the cause added"}, {"why"}}, rows);
}

}  // namespace

void addHowFar(report::Page& page, const Diagnosis& diagnosis) {
  page.section("How far does the gap shrink?", "shrink");
  if (diagnosis.after) {
    page.lead(
        diagnosis.weak_hold_out
            ? "Before and after the cause was added to the simulation, on samples of which one half of the beams "
              "took no part in fitting it; all their beams are shown."
            : "Before and after the cause was added to the simulation, on samples that were kept aside: they took "
              "no part in fitting it.");
    page.paragraph(
        report::text("The ") + report::link("#word-total-gap", "total gap") +
        report::text(fmt::format(" falls from {} to {}: it shrinks by {} (90 % interval {}). Samples: {}.",
                                 core::significant(diagnosis.before.total), core::significant(diagnosis.after->total),
                                 percent(diagnosis.shrink.fraction), percentInterval(diagnosis.shrink.interval),
                                 core::join(diagnosis.held_out))));
  } else {
    page.lead("How far the simulation is from the measurement; no cause was added, so there is no “after”.");
    page.paragraph(report::text("The ") + report::link("#word-total-gap", "total gap") +
                   report::text(fmt::format(" is {} on the samples {}.", core::significant(diagnosis.before.total),
                                            core::join(diagnosis.held_out))));
  }
  addNumbers(page, diagnosis);
  for (const BeforeAfterValues& values : diagnosis.curves) addCurves(page, values);
  if (diagnosis.after) addAcceptance(page, diagnosis);
}

}  // namespace gap
