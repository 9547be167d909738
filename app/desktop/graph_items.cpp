#include "app/desktop/graph_items.h"

#include <QApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <QStyleOptionGraphicsItem>
#include <cmath>

#include "app/desktop/colours.h"

namespace desktop {

namespace {

constexpr double kWidth = 212.0;
constexpr double kPadding = 8.0;
constexpr double kButton = 9.0;  // radius
constexpr double kTextWidth = kWidth - 2 * kPadding - kButton;
constexpr int kWrap = Qt::TextWordWrap | Qt::AlignLeft | Qt::AlignTop;

QFont titleFont() {
  QFont font = QApplication::font();
  font.setPointSizeF(10);
  return font;
}

QFont blockFont() {
  QFont font = QApplication::font();
  font.setPointSizeF(7.5);
  font.setLetterSpacing(QFont::AbsoluteSpacing, 0.3);
  return font;
}

double blockHeight() { return QFontMetricsF(blockFont()).height(); }

}  // namespace

NodeItem::NodeItem(std::size_t node, const percollect::Node& content)
    : node_(node),
      kind_(content.kind),
      block_(QString::fromStdString(content.block)),
      title_(QString::fromStdString(content.title)),
      size_(sizeFor(content)) {
  setFlag(ItemIsSelectable);
  setCursor(Qt::PointingHandCursor);
  setToolTip(title_ + "\n" + wordFor(kind_) + " · " + block_);
  setZValue(1);
}

QSizeF NodeItem::sizeFor(const percollect::Node& content) {
  const QRectF text = QFontMetricsF(titleFont())
                          .boundingRect(QRectF(0, 0, kTextWidth, 1000), kWrap, QString::fromStdString(content.title));
  return {kWidth, std::ceil(text.height() + blockHeight() + 1.6 * kPadding)};
}

void NodeItem::setEmphasis(Emphasis emphasis) {
  emphasis_ = emphasis;
  setOpacity(emphasis == Emphasis::Dimmed ? 0.22 : 1.0);
  update();
}

void NodeItem::setFolding(bool foldable, std::size_t hidden) {
  prepareGeometryChange();
  foldable_ = foldable;
  hidden_ = hidden;
}

QRectF NodeItem::box() const { return {-size_.width() / 2, -size_.height() / 2, size_.width(), size_.height()}; }

QRectF NodeItem::button() const {
  const double width = hidden_ > 0 ? 2 * kButton + 10 : 2 * kButton;
  return {size_.width() / 2 - width / 2, -kButton, width, 2 * kButton};  // half outside, clear of the title
}

bool NodeItem::onFoldButton(const QPointF& scene_position) const {
  return foldable_ && button().adjusted(-3, -3, 3, 3).contains(mapFromScene(scene_position));
}

QRectF NodeItem::boundingRect() const { return box().united(button()).adjusted(-3, -3, 3, 3); }

void NodeItem::paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) {
  const QPalette palette = widget ? widget->palette() : QApplication::palette();
  const QColor colour = colourOf(kind_);
  const bool strong = emphasis_ == Emphasis::Selected || emphasis_ == Emphasis::Hit;
  painter->setBrush(tint(palette, colour, emphasis_ == Emphasis::Selected ? 0.38 : 0.16));
  painter->setPen(QPen(strong ? palette.color(QPalette::Text) : colour, strong ? 2.6 : 1.2,
                       emphasis_ == Emphasis::Hit ? Qt::DashLine : Qt::SolidLine));
  painter->drawRoundedRect(box(), 6, 6);
  painter->setPen(Qt::NoPen);
  painter->setBrush(colour);  // a band that carries the kind even where the tint is faint
  painter->drawRoundedRect(QRectF(box().left(), box().top(), 5, box().height()), 2, 2);

  const double detail = QStyleOptionGraphicsItem::levelOfDetailFromTransform(painter->worldTransform());
  QRectF text = box().adjusted(kPadding + 3, 0.8 * kPadding, -kPadding, -0.8 * kPadding);
  if (detail > 0.45) {
    painter->setPen(muted(palette));
    painter->setFont(blockFont());
    painter->drawText(text, Qt::AlignLeft | Qt::AlignTop, block_.toUpper());
  }
  text.setTop(text.top() + blockHeight());
  painter->setPen(palette.color(QPalette::Text));
  painter->setFont(titleFont());
  painter->drawText(text.adjusted(0, 0, -kButton + 4, 8), kWrap, title_);
  if (!foldable_) return;
  painter->setBrush(hidden_ > 0 ? palette.color(QPalette::Text) : palette.color(QPalette::Base));
  painter->setPen(QPen(palette.color(QPalette::Text), 1));
  painter->drawRoundedRect(button(), kButton, kButton);
  painter->setPen(hidden_ > 0 ? palette.color(QPalette::Base) : palette.color(QPalette::Text));
  painter->setFont(blockFont());
  painter->drawText(button(), Qt::AlignCenter, hidden_ > 0 ? "+" + QString::number(hidden_) : QString::fromUtf8("−"));
  Q_UNUSED(option)
}

EdgeItem::EdgeItem(percollect::Edge edge, QPainterPath path) : edge_(edge), path_(std::move(path)) {}

void EdgeItem::setEmphasis(Emphasis emphasis) {
  emphasis_ = emphasis;
  setZValue(emphasis == Emphasis::Chain ? 0.5 : 0);
  setOpacity(emphasis == Emphasis::Dimmed ? 0.12 : 1.0);
  update();
}

QRectF EdgeItem::boundingRect() const { return path_.boundingRect().adjusted(-8, -8, 8, 8); }

void EdgeItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget* widget) {
  const QPalette palette = widget ? widget->palette() : QApplication::palette();
  const bool chain = emphasis_ == Emphasis::Chain;
  const QColor colour = chain ? readable(palette, accent::kRed) : tint(palette, palette.color(QPalette::Text), 0.45);
  painter->setPen(QPen(colour, chain ? 2.2 : 1.1));
  painter->setBrush(Qt::NoBrush);
  painter->drawPath(path_);
  if (path_.isEmpty()) return;
  const double angle = path_.angleAtPercent(0.98) * M_PI / 180;
  const QPointF tip = path_.pointAtPercent(1.0);
  const auto side = [&](double turn) {
    constexpr double kHead = 8.0;
    return tip - kHead * QPointF(std::cos(angle + turn), -std::sin(angle + turn));
  };
  painter->setPen(Qt::NoPen);
  painter->setBrush(colour);
  painter->drawPolygon(QPolygonF({tip, side(0.4), side(-0.4)}));
}

}  // namespace desktop
