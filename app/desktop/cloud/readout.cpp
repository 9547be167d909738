#include "app/desktop/cloud/readout.h"

#include <QObject>
#include <cmath>
#include <map>
#include <numbers>

#include "app/desktop/html.h"

namespace desktop {

namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kNano = 1e9;

QString tr(const char* text) { return QObject::tr(text); }

QString number(double value, int decimals, const QString& unit) {
  return QString::number(value, 'f', decimals) + " " + unit;
}

QString difference(double other, double own, int decimals, const QString& unit) {
  const double by = other - own;
  return number(other, decimals, unit) + " (" + (by >= 0 ? "+" : "−") + QString::number(std::abs(by), 'f', decimals) +
         ")";
}

QString htmlOf(const ReadoutPart& part) {
  QString html;
  if (!part.note.isEmpty()) html += html::paragraph(part.note.toHtmlEscaped());
  if (part.rows.empty()) return html;
  html += "<table>";
  for (const auto& [name, value] : part.rows) {
    html += "<tr><td style='padding-right:14px'>" + name.toHtmlEscaped() + "</td><td align='right'>" +
            value.toHtmlEscaped() + "</td></tr>";
  }
  return html + "</table>";
}

ReadoutPart partOfEchoes(const model::BeamExplanation& beam) {
  ReadoutPart part{.title = tr("Echoes"), .note = {}, .rows = {}};
  int number_of_echo = 0;
  for (const model::Echo& echo : beam.shot.echoes) {
    const bool detected = echo.fate == model::Fate::kDetected;
    const QString name =
        detected ? tr("echo %1").arg(++number_of_echo) : QString::fromStdString(model::toString(echo.fate));
    part.rows.emplace_back(name, number(echo.range_m, 3, "m") + ", " + number(kNano * echo.peak_w, 2, "nW"));
  }
  if (part.rows.empty()) part.note = tr("none");
  return part;
}

/// Sub-rays and power by object: which surfaces the beam lies on.
ReadoutPart partOfRays(const model::BeamExplanation& beam) {
  struct Share {
    int rays = 0;
    double power_w = 0.0;
  };
  std::map<std::string, Share> objects;
  for (const model::SubRayExplanation& ray : beam.rays) {
    Share& share = objects[ray.object];
    ++share.rays;
    share.power_w += ray.power_w;
  }
  ReadoutPart part{.title = tr("Sub-rays"), .note = {}, .rows = {}};
  for (const auto& [object, share] : objects) {
    const QString power = object.empty() ? QString() : ", " + number(kNano * share.power_w, 2, "nW");
    part.rows.emplace_back(object.empty() ? tr("nothing") : QString::fromStdString(object),
                           QString::number(share.rays) + power);
  }
  return part;
}

}  // namespace

QString toHtml(const Readout& readout, const QPalette& palette) {
  QString html;
  for (const ReadoutPart& part : readout) {
    html += html.isEmpty() ? html::heading(part.title) : html::section(part.title, palette);
    html += htmlOf(part);
  }
  return html;
}

QString toText(const Readout& readout) {
  QString text;
  for (const ReadoutPart& part : readout) {
    text += part.title + "\n";
    if (!part.note.isEmpty()) text += part.note + "\n";
    for (const auto& [name, value] : part.rows) text += name + "\t" + value + "\n";
  }
  return text;
}

ReadoutPart partOf(const PointCloud& cloud, CloudSource source, std::size_t i, const QString& sample) {
  const core::Detections& d = cloud.detections;
  const bool silent = source == CloudSource::Silent;
  ReadoutPart part{.title = silent                            ? tr("Beam without detection")
                            : source == CloudSource::Measured ? tr("Measured detection")
                                                              : tr("Simulated detection"),
                   .note = {},
                   .rows = {}};
  const auto add = [&](const QString& name, const QString& value) { part.rows.emplace_back(name, value); };
  add(tr("Sample"), sample);
  add(tr("Frame"), QString::number(d.frame[i]));
  if (d.time_s.size() == d.size()) add(tr("Time in frame"), number(1e3 * d.time_s[i], 3, "ms"));
  if (!d.layer.empty()) add(tr("Layer"), QString::number(d.layer[i]));
  add(tr("Azimuth"), number(kDegrees * d.azimuth_rad[i], 3, "°"));
  add(tr("Elevation"), number(kDegrees * d.elevation_rad[i], 3, "°"));
  if (silent) return part;
  add(tr("Echo"), QString::number(d.echo[i]));
  add(tr("Range"), number(d.range_m[i], 3, "m"));
  if (!d.epw_m.empty()) add(tr("Echo pulse width"), number(d.epw_m[i], 3, "m"));
  if (!d.intensity.empty()) add(tr("Intensity"), number(d.intensity[i], 2, "nW"));
  add("x", number(double(cloud.x[i]), 3, "m"));
  add("y", number(double(cloud.y[i]), 3, "m"));
  add("z", number(double(cloud.z[i]), 3, "m"));
  return part;
}

ReadoutPart partOfOther(const PointCloud& other, CloudSource source, const PointCloud& own, std::size_t index) {
  ReadoutPart part{
      .title = source == CloudSource::Measured ? tr("The same beam, measured") : tr("The same beam, simulated"),
      .note = {},
      .rows = {}};
  const auto there = sameBeam(other, own, index);
  const auto here = own.detections.echo[index] > 0 ? sameBeam(own, own, index) : std::nullopt;
  if (!there) {
    part.note = tr("No detection with this echo number.");
    return part;
  }
  if (!here) {  // a beam without detection
    part.note = tr("mean over all frames: %1 detections").arg(there->count);
    part.rows.emplace_back(tr("Range"), number(there->range_m, 3, "m"));
    if (there->intensity_nw) part.rows.emplace_back(tr("Intensity"), number(*there->intensity_nw, 2, "nW"));
    return part;
  }
  const bool one = there->count == 1 && here->count == 1;
  part.note = one ? tr("and its difference to the detection above")
                  : tr("means over all frames: %1 detections here, %2 there").arg(here->count).arg(there->count);
  part.rows.emplace_back(tr("Range"), difference(there->range_m, here->range_m, 3, "m"));
  if (there->epw_m && here->epw_m) {
    part.rows.emplace_back(tr("Echo pulse width"), difference(*there->epw_m, *here->epw_m, 3, "m"));
  }
  if (there->intensity_nw && here->intensity_nw) {
    part.rows.emplace_back(tr("Intensity"), difference(*there->intensity_nw, *here->intensity_nw, 2, "nW"));
  }
  return part;
}

QString explained(model::Reason reason) {
  const QString word = QString::fromStdString(model::toString(reason));
  switch (reason) {
    case model::Reason::kDetected:
      return word;
    case model::Reason::kNoHit:
      return word + ": " + tr("the beam meets nothing.");
    case model::Reason::kBelowThreshold:
      return word + ": " + tr("the received signal stays below the threshold.");
    case model::Reason::kBlinded:
      return word + ": " + tr("the receiver could not see the echo.");
    case model::Reason::kLost:
      return word + ": " + tr("an effect drops the echo by chance.");
    case model::Reason::kOutsideWindow:
      return word + ": " + tr("the echo lies nearer or farther than the sensor reports.");
  }
  return word;
}

Readout partsOf(const model::BeamExplanation& beam) {
  ReadoutPart what{.title = tr("What the model receives"), .note = explained(beam.reason), .rows = {}};
  what.rows.emplace_back(tr("Threshold"), number(kNano * beam.shot.receiver.threshold_w, 3, "nW"));
  return {what, partOfEchoes(beam), partOfRays(beam)};
}

Readout readoutOf(const QString& title, const core::InputError& error) {
  Readout readout{{.title = title, .note = QString::fromStdString(error.problem()), .rows = {}}};
  const QString where = QString::fromStdString(core::toString(error.place()));
  const QString remedy = QString::fromStdString(error.remedy());
  if (!where.isEmpty()) readout.push_back({.title = tr("Where"), .note = where, .rows = {}});
  if (!remedy.isEmpty()) readout.push_back({.title = tr("What to do"), .note = remedy, .rows = {}});
  return readout;
}

}  // namespace desktop
