#include "app/desktop/cloud/waveform_view.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/desktop/cloud/colour_scale.h"
#include "app/desktop/colours.h"

namespace desktop {

namespace {

constexpr double kNano = 1e9;

QString wordFor(model::Fate fate) { return QString::fromStdString(model::toString(fate)); }

}  // namespace

/// Where numbers stand in the widget.
struct WaveformView::Axes {
  QRectF plot;
  double low_m;
  double high_m;
  double top_nw;

  [[nodiscard]] double x(double range_m) const {
    return plot.left() + (range_m - low_m) / (high_m - low_m) * plot.width();
  }
  [[nodiscard]] double y(double power_w) const {
    return plot.bottom() - std::min(1.0, power_w * kNano / top_nw) * plot.height();
  }
};

WaveformView::WaveformView(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Received signal of the beam"));
  setBackgroundRole(QPalette::Base);
  setAutoFillBackground(true);
}

void WaveformView::show(model::BeamExplanation beam, std::optional<double> reported_m, const QColor& colour) {
  beam_ = std::move(beam);
  reported_m_ = reported_m;
  colour_ = colour;
  update();
}

void WaveformView::clear(const QString& instead) {
  beam_.reset();
  instead_ = instead;
  update();
}

WaveformView::Axes WaveformView::axes() const {
  const QFontMetrics metrics(font());
  const double line = metrics.lineSpacing();
  Axes axes{
      .plot = QRectF(rect()).adjusted(metrics.horizontalAdvance("0.000") + 14, 3.4 * line + 10, -14, -2.2 * line - 8),
      .low_m = reported_m_ ? *reported_m_ - 1.0 : std::numeric_limits<double>::infinity(),
      .high_m = reported_m_ ? *reported_m_ + 1.0 : -std::numeric_limits<double>::infinity(),
      .top_nw = 1.4 * kNano * beam_->shot.receiver.threshold_w};
  for (const model::WaveformSample& sample : beam_->waveform) {
    axes.low_m = std::min(axes.low_m, sample.range_m);
    axes.high_m = std::max(axes.high_m, sample.range_m);
    axes.top_nw = std::max(axes.top_nw, 1.1 * kNano * sample.power_w);
  }
  for (const model::Echo& echo : beam_->shot.echoes) axes.top_nw = std::max(axes.top_nw, 1.1 * kNano * echo.peak_w);
  if (!(axes.low_m < axes.high_m)) {  // nothing came back: an empty axis
    axes.low_m = 0.0;
    axes.high_m = 100.0;
  }
  return axes;
}

void WaveformView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (!beam_) {
    painter.setPen(muted(palette()));
    painter.drawText(rect().adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap, instead_);
    return;
  }
  const Axes where = axes();
  drawFrame(painter, where);
  drawSignal(painter, where);
  drawEchoes(painter, where);
}

void WaveformView::drawFrame(QPainter& painter, const Axes& axes) const {
  const double line = QFontMetrics(font()).lineSpacing();
  painter.setPen(palette().color(QPalette::Text));
  const auto write = [&](double top, const QFont& with, const QString& text) {
    painter.setFont(with);
    const QString fits = QFontMetrics(with).elidedText(text, Qt::ElideRight, width() - 20);
    painter.drawText(QRectF(10, top, width() - 20, line), Qt::AlignLeft | Qt::AlignVCenter, fits);
  };
  QFont bold = font();
  bold.setBold(true);
  write(6, bold, tr("Received signal: %1").arg(QString::fromStdString(model::toString(beam_->reason))));
  painter.setPen(muted(palette()));
  write(6 + line, font(), reported_m_ ? tr("without noise; dotted: picked range") : tr("without noise"));
  write(6 + 2 * line, font(), tr("power [nW]"));
  painter.drawText(QRectF(10, height() - line - 4, width() - 20, line), Qt::AlignCenter, tr("range [m]"));
  if (beam_->waveform.empty()) {
    painter.drawText(axes.plot, Qt::AlignCenter | Qt::TextWordWrap, tr("No light comes back."));
  }
  const QPen grid(tint(palette(), palette().color(QPalette::Text), 0.15), 1);
  const double step_m = roundStep((axes.high_m - axes.low_m) / 4.0);
  for (double at = std::ceil(axes.low_m / step_m) * step_m; at <= axes.high_m; at += step_m) {
    painter.setPen(grid);
    painter.drawLine(QPointF(axes.x(at), axes.plot.top()), QPointF(axes.x(at), axes.plot.bottom()));
    painter.setPen(muted(palette()));
    painter.drawText(QRectF(axes.x(at) - 40, axes.plot.bottom() + 3, 80, line), Qt::AlignCenter,
                     QString::number(at, 'g', 5));
  }
  const double step_nw = roundStep(axes.top_nw / 3.0);
  for (double at = 0.0; at <= axes.top_nw; at += step_nw) {
    painter.setPen(grid);
    painter.drawLine(QPointF(axes.plot.left(), axes.y(at / kNano)), QPointF(axes.plot.right(), axes.y(at / kNano)));
    painter.setPen(muted(palette()));
    painter.drawText(QRectF(0, axes.y(at / kNano) - 0.5 * line, axes.plot.left() - 6, line),
                     Qt::AlignRight | Qt::AlignVCenter, QString::number(at, 'g', 4));
  }
}

void WaveformView::drawSignal(QPainter& painter, const Axes& axes) const {
  const auto& samples = beam_->waveform;
  QPainterPath line;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const QPointF at(axes.x(samples[i].range_m), axes.y(samples[i].power_w));
    // Samples stand densely wherever there are pulses; in between is nothing.
    const bool gap = i == 0 || samples[i].range_m - samples[i - 1].range_m > 1.0;
    if (gap && i > 0) line.lineTo(axes.x(samples[i - 1].range_m), axes.plot.bottom());
    if (gap) line.moveTo(at.x(), axes.plot.bottom());
    line.lineTo(at);
  }
  if (!samples.empty()) line.lineTo(axes.x(samples.back().range_m), axes.plot.bottom());
  painter.setPen(QPen(accent::kBlue, 1.6));
  painter.setBrush(tint(palette(), accent::kBlue, 0.18));
  painter.drawPath(line);
  painter.setPen(QPen(accent::kBlue, 1));
  for (const model::Pulse& pulse : beam_->shot.pulses) {
    const QPointF foot(axes.x(pulse.range_m), axes.plot.bottom());
    painter.drawLine(foot, QPointF(foot.x(), axes.y(pulse.power_w)));
  }
  const double threshold = axes.y(beam_->shot.receiver.threshold_w);
  painter.setPen(QPen(readable(palette(), accent::kRed), 1.4, Qt::DashLine));
  painter.drawLine(QPointF(axes.plot.left(), threshold), QPointF(axes.plot.right(), threshold));
  painter.drawText(QPointF(axes.plot.left() + 4, threshold - 4), tr("threshold"));
}

void WaveformView::drawEchoes(QPainter& painter, const Axes& axes) const {
  const double line = QFontMetrics(font()).lineSpacing();
  if (reported_m_) {
    const double x = axes.x(*reported_m_);
    painter.setPen(QPen(colour_.darker(isDark(palette()) ? 100 : 130), 1.6, Qt::DotLine));
    painter.drawLine(QPointF(x, axes.plot.top()), QPointF(x, axes.plot.bottom()));
  }
  int number = 0;
  for (const model::Echo& echo : beam_->shot.echoes) {
    const QPointF at(axes.x(echo.range_m), axes.y(echo.peak_w));
    const bool detected = echo.fate == model::Fate::kDetected;
    painter.setPen(QPen(palette().color(QPalette::Text), 1.4));
    painter.setBrush(detected ? palette().color(QPalette::Text) : palette().color(QPalette::Base));
    painter.drawEllipse(at, 3.5, 3.5);
    const QString word = detected ? tr("echo %1").arg(++number) : wordFor(echo.fate);
    const double wide = QFontMetrics(font()).horizontalAdvance(word);
    const bool left = at.x() + 8 + wide > axes.plot.right();
    painter.drawText(QPointF(left ? at.x() - 8 - wide : at.x() + 8, std::max(at.y(), axes.plot.top() + 0.7 * line)),
                     word);
  }
}

}  // namespace desktop
