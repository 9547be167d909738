#include "app/desktop/diagnosis/diagnosis_text.h"

#include <QObject>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "app/desktop/colours.h"
#include "app/desktop/html.h"
#include "core/text.h"
#include "gap/report/quantities.h"
#include "gap/report/rest_wording.h"
#include "gap/report/titles.h"
#include "gap/report/wording.h"

namespace desktop {

namespace {

using proposals::GapReport;

constexpr std::size_t kPlaces = 6;  // further ones say the same in other words
constexpr int kBar_px = 90;

QString number(double value, int digits = 3) { return QString::fromStdString(core::significant(value, digits)); }
/// Two digits below 10 %, whole percents above.
QString percent(double share) { return number(100.0 * share, std::abs(share) < 0.1 ? 2 : 3) + " %"; }
QString withUnit(double value, const std::string& unit) { return html::text(gap::withUnit(value, unit)); }

QString cell(const QString& markup, bool right = false) {
  return QStringLiteral("<td style='padding:3px 14px 3px 0; white-space:nowrap'%1>%2</td>")
      .arg(right ? QStringLiteral(" align='right'") : QString(), markup);
}

/// Breaks into lines where the window is narrow.
QString sentence(const QString& markup) {
  return QStringLiteral("<td style='padding:3px 14px 3px 0'>%1</td>").arg(markup);
}

QString head(const QStringList& titles, const QPalette& palette) {
  QString row;
  for (const QString& word : titles) {
    row += QStringLiteral("<td style='padding:0 14px 3px 0; white-space:nowrap'>%1</td>")
               .arg(html::muted(word.toHtmlEscaped(), palette));
  }
  return "<tr>" + row + "</tr>";
}

QString table(const QString& rows) { return "<table cellspacing='0' style='margin-bottom:6px'>" + rows + "</table>"; }

QString title(const QString& text) {
  return QStringLiteral("<p style='margin:18px 0 4px 0; font-size:15px; font-weight:600'>%1</p>")
      .arg(text.toHtmlEscaped());
}

/// A share as a bar; the number stands beside it.
QString bar(double share, const QColor& colour, const QPalette& palette) {
  const int full = std::clamp(int(std::lround(share * kBar_px)), 1, kBar_px);
  const QString rest = full < kBar_px ? QStringLiteral("<td width='%1' bgcolor='%2' style='font-size:7px'>&nbsp;</td>")
                                            .arg(kBar_px - full)
                                            .arg(tint(palette, colour, 0.12).name())
                                      : QString();
  return QStringLiteral(
             "<table cellspacing='0' cellpadding='0' width='%1'><tr><td width='%2' bgcolor='%3' "
             "style='font-size:7px'>&nbsp;</td>%4</tr></table>")
      .arg(kBar_px)
      .arg(full)
      .arg(tint(palette, colour, 0.75).name(), rest);
}

/// The interval of what a cause shrinks; nothing if it was not computed.
QString interval(const gap::Shrink& shrink) {
  if (shrink.interval.low == shrink.interval.high) return {};
  return " " + html::text(gap::shrinkInterval(shrink.fraction, shrink.interval));
}

QString verdictPart(const GapReport& report, const QPalette& palette) {
  // The first sentence is the verdict, what follows says how far to trust it.
  const std::size_t stop = report.verdict.text.find(". ");
  const std::size_t end = stop == std::string::npos ? report.verdict.text.size() : stop + 1;
  QString page = QStringLiteral("<p style='margin:2px 0 6px 0; font-size:19px; font-weight:600'>%1</p>")
                     .arg(html::text(report.verdict.text.substr(0, end)));
  if (end < report.verdict.text.size())
    page += html::paragraph(html::text(core::trimmed(report.verdict.text.substr(end))));
  for (const std::string& name : report.verdict.names) {
    const std::string summary = gap::causeSummary(name);
    if (!summary.empty()) page += html::paragraph("<i>" + html::text(name + ": " + summary) + "</i>");
  }
  if (const gap::Law* pattern = gap::patternIn(report.verdict, report.rest))
    page += html::paragraph(html::text(gap::patternText(*pattern)));
  QString facts = QObject::tr("Experiment %1, model %2.").arg(html::text(report.experiment), html::text(report.model));
  if (!report.verdict.indistinguishable_from.empty()) {
    facts += " " + QObject::tr("These data cannot tell it from %1.")
                       .arg(html::text(core::join(report.verdict.indistinguishable_from, " or ")));
  }
  page += html::paragraph(html::muted(facts, palette));
  if (report.synthetic) {
    page += html::paragraph("<b>" + QObject::tr("Synthetic data: made by a program, not measured.") + "</b>");
  }
  return page;
}

/// The causes rest on a proxy that says nothing of the model under test.
bool misleads(const GapReport& report) {
  return report.present && report.approximation && !report.approximation->reliable();
}

/// A box that nobody reads past.
QString warning(const QString& first, const QString& markup, const QPalette& palette) {
  return QStringLiteral(
             "<table width='100%' cellspacing='0' cellpadding='10' bgcolor='%1' style='margin:6px 0 6px 0'>"
             "<tr><td><b>%2</b><br/>%3</td></tr></table>")
      .arg(tint(palette, accent::kRed, 0.2).name(), first.toHtmlEscaped(), markup);
}

/// What a reader must know of the data and of the proxy to weigh the verdict.
QString trustPart(const GapReport& report, const QPalette& palette) {
  QString page;
  QStringList sentences;
  if (misleads(report)) {
    page += warning(QObject::tr("Do not rely upon the causes"), html::text(report.approximation->text), palette);
  } else if (report.approximation) {
    sentences << html::text(report.approximation->text);
  }
  for (const std::string& note : report.notes) sentences << html::text(note);
  if (sentences.isEmpty()) return page;
  page += html::section(QObject::tr("To bear in mind"), palette);
  for (const QString& sentence : sentences) page += html::paragraph(sentence);
  return page;
}

QString wherePart(const GapReport& report, const QPalette& palette) {
  if (report.where.empty()) return {};
  QString rows = head({QObject::tr("Measurand"), QObject::tr("What"), QObject::tr("Where"),
                       QObject::tr("Measured − simulated"), QObject::tr("Share of this gap"), ""},
                      palette);
  for (std::size_t i = 0; i < std::min(kPlaces, report.where.size()); ++i) {
    const gap::WhereRow& place = report.where[i];
    rows += "<tr>" + cell(html::text(place.measurand)) + cell(html::text(place.component)) +
            sentence(html::text(gap::stratumText(place))) + cell(withUnit(place.value, place.unit), true) +
            cell(bar(place.share, accent::kOrange, palette)) + cell(percent(place.share), true) + "</tr>";
  }
  return title(QObject::tr("Where do they differ?")) + table(rows);
}

QString parametersOf(const gap::Cause& cause) {
  std::vector<gap::FittedParameter> parameters = cause.parameters;
  for (const auto& [setup, offset] : cause.setups) parameters.push_back(offset);
  QStringList parts;
  for (const gap::FittedParameter& p : parameters) {
    const std::string unit = gap::unitOf(p);
    const std::string range = p.interval ? " (" + gap::intervalText(*p.interval, unit) + ")" : "";
    parts << html::text(p.name + " = " + gap::withUnit(p.value, unit) + range);
  }
  return parts.join("<br/>");
}

/// "effect · per set-up · sensor front only"
QString kindOf(const gap::Cause& cause) {
  QStringList parts{QString::fromStdString(gap::toString(cause.kind))};
  if (!cause.variant.empty()) parts << QString::fromStdString(cause.variant);
  if (!cause.sensors.empty())
    parts << QObject::tr("sensor %1 only").arg(QString::fromStdString(core::join(cause.sensors)));
  return parts.join(QStringLiteral(" · "));
}

QString causesPart(const GapReport& report, const QPalette& palette) {
  if (report.causes.empty()) return {};
  QString rows = head({QObject::tr("Cause"), QObject::tr("Explains"), "", QObject::tr("Shrinks the gap by"),
                       QObject::tr("Confidence"), QObject::tr("Fitted, with 95 % interval")},
                      palette);
  for (const gap::Cause& cause : report.causes) {
    const bool named = report.verdict.holds(cause.name);
    const QString name = html::text(cause.name);
    const QString kind = html::muted(kindOf(cause).toHtmlEscaped(), palette);
    rows += "<tr>" + cell((named ? "<b>" + name + "</b>" : name) + "<br/>" + kind) +
            cell(bar(cause.explained, named ? accent::kTeal : accent::kBlue, palette)) +
            cell(percent(cause.explained), true) +
            cell(html::text(gap::shrinkOf(cause.shrink.fraction)) + interval(cause.shrink)) +
            cell(percent(cause.confidence), true) + sentence(parametersOf(cause)) + "</tr>";
  }
  QString page = title(QObject::tr("Which cause?")) + table(rows);
  const auto effects = report.namedEffects();
  if (!effects.empty() && !effects.front()->chain_titles.empty()) {
    page += html::paragraph(html::muted(QObject::tr("In the graph: "), palette) +
                            html::text(core::join(effects.front()->chain_titles, " → ")));
  }
  return page;
}

QString beforeAfter(double before, const std::optional<double>& after, const proposals::ReportedGap& gap) {
  const bool share = gap.name == "missing" || gap.name == "extra";
  const auto shown = [&](double value) { return share ? percent(value) : withUnit(value, gap.unit); };
  if (!after || shown(before) == shown(*after)) return shown(before);
  return shown(before) + " → <b>" + shown(*after) + "</b>";
}

QString howFarPart(const GapReport& report, const QPalette& palette) {
  QString rows = head(
      {QObject::tr("Measurand"), QObject::tr("Bias (simulated too high: +)"), QObject::tr("Scatter error")}, palette);
  for (const proposals::ReportedGap& gap : report.gaps) {
    const bool share = gap.name == "missing" || gap.name == "extra";
    const QString name = share ? html::text(gap.name + " echoes") : html::text(gap.name);
    rows += "<tr>" + cell(name) + cell(beforeAfter(gap.bias, gap.bias_after, gap)) +
            cell(share ? QString() : beforeAfter(gap.scatter, gap.scatter_after, gap)) + "</tr>";
  }
  QString page =
      title(report.shrink ? QObject::tr("How far does the gap shrink?") : QObject::tr("How large is the gap?"));
  if (report.shrink) {
    const QString where = report.half_of_the_beams_fitted
                              ? QObject::tr("on samples of which the fit saw one half of the beams")
                              : QObject::tr("on samples that no fit has seen");
    QString text =
        QObject::tr("By <b>%1</b>%2 %3").arg(percent(report.shrink->fraction), interval(*report.shrink), where);
    if (!report.held_out.empty()) text += " (" + html::text(core::join(report.held_out)) + ")";
    if (report.totals) {
      text +=
          QObject::tr(": total gap %1 → <b>%2</b>").arg(number(report.totals->first), number(report.totals->second));
    }
    page += html::paragraph(text + ".");
  }
  return page + table(rows);
}

QString restPart(const GapReport& report, const QPalette& palette) {
  if (!report.rest) return {};
  const gap::Rest& rest = *report.rest;
  QString page = title(QObject::tr("What is left unexplained?")) +
                 html::paragraph(html::text(gap::restText(rest, !report.verdict.names.empty())));
  if (rest.laws.empty() || gap::hardlyAnyLeft(rest)) return page;
  QString rows =
      head({QObject::tr("Difference"), QObject::tr("Measured − simulated ≈"), "", QObject::tr("Follows the formula")},
           palette);
  for (const gap::Law& found : rest.laws) {
    const gap::Law law = gap::forReaders(found);
    rows += "<tr>" + cell(html::text(gap::componentTitle(law.measurand, law.component))) +
            sentence(html::text(gap::formulaOf(law))) + cell(html::text(law.unit)) +
            cell(percent(law.explained), true) + "</tr>";
  }
  return page + table(rows) +
         html::paragraph(html::muted(QObject::tr("A formula is a hint where to look, not a cause."), palette));
}

QString flipsPart(const GapReport& report, const QPalette& palette) {
  if (report.flips.empty()) return {};
  QString rows;
  for (const gap::TwiceJudgedTest& flip : report.flips) {
    rows += "<tr>" + cell(html::link("test:" + QString::fromStdString(flip.id), QString::fromStdString(flip.id))) +
            cell(html::text(flip.title)) + cell(html::text(flip.before) + " → <b>" + html::text(flip.after) + "</b>") +
            "</tr>";
  }
  return title(QObject::tr("Acceptance tests whose verdict changes")) +
         table(head({QObject::tr("Test"), "", QObject::tr("With the cause")}, palette) + rows);
}

}  // namespace

QString diagnosisText(const GapReport& report, const QPalette& palette) {
  QString page = verdictPart(report, palette) + trustPart(report, palette) + wherePart(report, palette) +
                 causesPart(report, palette) + howFarPart(report, palette) + restPart(report, palette) +
                 flipsPart(report, palette);
  if (!report.next_experiment.empty()) {
    page += title(QObject::tr("What to measure next")) + html::paragraph(html::text(report.next_experiment));
  }
  return page;
}

QString diagnosisHint(bool any_experiment, const QPalette& palette) {
  QString page = html::heading(QObject::tr("No diagnosis is open"));
  page +=
      html::paragraph(QObject::tr("A diagnosis says where simulation and measurement differ, which effect the model "
                                  "lacks, and how far the gap shrinks with it."));
  page +=
      any_experiment
          ? html::paragraph(QObject::tr("Choose an experiment and a model above and press <b>Diagnose</b>, or <b>Open "
                                        "report…</b> for one that <code>fidelis gap --json</code> wrote."))
          : html::paragraph(QObject::tr("The project's acceptance tests name no experiment yet. <b>Choose…</b> one in "
                                        "the list above, or <b>Open report…</b>."));
  return page + html::paragraph(html::muted(
                    QObject::tr("Then <b>Propose</b> what follows for the relevance table; you accept or dismiss it."),
                    palette));
}

}  // namespace desktop
