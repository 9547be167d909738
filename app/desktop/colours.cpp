#include "app/desktop/colours.h"

#include <QObject>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>
#include <algorithm>
#include <cmath>

namespace desktop {

namespace {

QColor mixed(const QColor& a, const QColor& b, double share_of_b) {
  const auto mix = [&](float x, float y) { return x + (y - x) * float(share_of_b); };
  return QColor::fromRgbF(mix(a.redF(), b.redF()), mix(a.greenF(), b.greenF()), mix(a.blueF(), b.blueF()));
}

double luminance(const QColor& colour) {
  const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
}

/// A filled disc or square with a white sign in it, drawn at twice the size for sharp edges.
QIcon sign(const QColor& colour, bool round, const QPainterPath& path) {
  constexpr int kSize = 32;
  QPixmap pixmap(kSize, kSize);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colour);
  if (round) {
    painter.drawEllipse(QRectF(2, 2, 28, 28));
  } else {
    painter.drawRoundedRect(QRectF(2, 2, 28, 28), 5, 5);
  }
  painter.setPen(QPen(Qt::white, 4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(path);
  painter.end();
  QIcon icon(pixmap);
  icon.addPixmap(pixmap, QIcon::Selected);  // a selection must not tint what the colour says
  return icon;
}

QPainterPath check() {
  QPainterPath path(QPointF(9, 17));
  path.lineTo(14, 22);
  path.lineTo(23, 11);
  return path;
}

QPainterPath cross() {
  QPainterPath path(QPointF(11, 11));
  path.lineTo(21, 21);
  path.moveTo(21, 11);
  path.lineTo(11, 21);
  return path;
}

QPainterPath bar() {
  QPainterPath path(QPointF(10, 16));
  path.lineTo(22, 16);
  return path;
}

QPainterPath exclamation() {
  QPainterPath path(QPointF(16, 8));
  path.lineTo(16, 17);
  path.moveTo(16, 23.5);
  path.lineTo(16, 24);
  return path;
}

QPainterPath eye() {
  QPainterPath path;
  path.addEllipse(QPointF(16, 16), 4, 4);
  return path;
}

const QColor kGrey(0x6b, 0x74, 0x7d);

QString textOf(std::string_view word) { return QString::fromUtf8(word.data(), qsizetype(word.size())); }

}  // namespace

bool isDark(const QPalette& palette) { return luminance(palette.color(QPalette::Base)) < 0.2; }

QColor tint(const QPalette& palette, const QColor& accent, double share) {
  return mixed(palette.color(QPalette::Base), accent, share);
}

double contrast(const QColor& a, const QColor& b) {
  const auto [low, high] = std::minmax({luminance(a), luminance(b)});
  return (high + 0.05) / (low + 0.05);
}

QColor muted(const QPalette& palette) {
  return mixed(palette.color(QPalette::Text), palette.color(QPalette::Base), 0.35);
}

QColor readable(const QPalette& palette, const QColor& accent) {
  const QColor base = palette.color(QPalette::Base);
  QColor colour = accent;
  for (int i = 0; i < 20 && contrast(colour, base) < 4.5; ++i) {
    colour = mixed(colour, palette.color(QPalette::Text), 0.15);
  }
  return colour;
}

QPalette lightPalette() {
  QPalette palette(QColor(0xf3, 0xf4, 0xf6));
  palette.setColor(QPalette::Base, Qt::white);
  palette.setColor(QPalette::AlternateBase, QColor(0xf7, 0xf8, 0xfa));
  palette.setColor(QPalette::Highlight, accent::kBlue);
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Link, QColor(0x00, 0x5a, 0x8f));
  palette.setColor(QPalette::PlaceholderText, QColor(0x6b, 0x74, 0x7d));
  return palette;
}

QPalette darkPalette() {
  QPalette palette(QColor(0x35, 0x39, 0x3f), QColor(0x2a, 0x2d, 0x32));
  palette.setColor(QPalette::Base, QColor(0x1e, 0x20, 0x24));
  palette.setColor(QPalette::AlternateBase, QColor(0x25, 0x28, 0x2d));
  palette.setColor(QPalette::Highlight, QColor(0x1b, 0x6f, 0xa8));
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Link, QColor(0x6c, 0xb8, 0xe8));
  palette.setColor(QPalette::PlaceholderText, QColor(0x9a, 0xa2, 0xab));
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText}) {
    palette.setColor(role, QColor(0xe6, 0xe8, 0xeb));
    palette.setColor(QPalette::Disabled, role, QColor(0x84, 0x8b, 0x93));
  }
  palette.setColor(QPalette::ToolTipBase, QColor(0x35, 0x39, 0x3f));
  return palette;
}

QColor colourOf(percollect::NodeKind kind) {
  switch (kind) {
    case percollect::NodeKind::Effect:
      return accent::kBlue;
    case percollect::NodeKind::DesignParameter:
      return accent::kTeal;
    case percollect::NodeKind::SystemIndependent:
      return accent::kOrange;
  }
  return accent::kBlue;
}

QString wordFor(percollect::NodeKind kind) {
  switch (kind) {
    case percollect::NodeKind::Effect:
      return QObject::tr("Effect");
    case percollect::NodeKind::DesignParameter:
      return QObject::tr("Design parameter");
    case percollect::NodeKind::SystemIndependent:
      return QObject::tr("System-independent cause");
  }
  return {};
}

QColor weightColour(const QPalette& palette, int value, int largest) {
  const double share = double(value) / largest;
  return tint(palette, accent::kRed, (isDark(palette) ? 0.75 : 0.55) * share * share);
}

QIcon iconOf(specs::Status status) {
  switch (status) {
    case specs::Status::Accepted:
      return sign(accent::kTeal.darker(115), false, check());
    case specs::Status::Rejected:
      return sign(accent::kPurple, false, cross());
    case specs::Status::UnderReview:
      return sign(kGrey, false, eye());
  }
  return {};
}

QIcon iconOf(specs::Verdict verdict) {
  switch (verdict) {
    case specs::Verdict::Passed:
      return sign(accent::kTeal.darker(115), true, check());
    case specs::Verdict::Failed:
      return sign(accent::kRed, true, cross());
    case specs::Verdict::Error:
      return sign(accent::kPurple, true, exclamation());
    case specs::Verdict::Skipped:
      return sign(kGrey, true, bar());
  }
  return {};
}

QIcon iconOf(specs::ProposalState state) {
  switch (state) {
    case specs::ProposalState::Open:
      return iconOf(specs::Status::UnderReview);
    case specs::ProposalState::Accepted:
      return iconOf(specs::Status::Accepted);
    case specs::ProposalState::Dismissed:
      return iconOf(specs::Status::Rejected);
  }
  return {};
}

QIcon warningIcon() { return sign(accent::kRed, false, exclamation()); }

QString wordFor(specs::Kind kind) { return textOf(specs::name(kind)); }
QString wordFor(specs::Status status) { return textOf(specs::name(status)); }
QString wordFor(specs::Verdict verdict) { return textOf(specs::name(verdict)); }
QString wordFor(specs::ProposalState state) { return textOf(specs::name(state)); }

}  // namespace desktop
