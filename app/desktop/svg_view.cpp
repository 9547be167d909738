#include "app/desktop/svg_view.h"

#include <QPainter>

namespace desktop {

SvgView::SvgView(QWidget* parent) : QWidget(parent) {
  setMinimumSize(200, 150);
  renderer_.setAspectRatioMode(Qt::KeepAspectRatio);
}

void SvgView::setSvg(const std::string& svg, const QString& instead) {
  renderer_.load(QByteArray::fromStdString(svg));
  instead_ = instead;
  update();
}

void SvgView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (!hasFigure()) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, instead_);
    return;
  }
  constexpr int kMargin = 8;
  const QSizeF size =
      QSizeF(renderer_.defaultSize()).scaled(this->size() - QSize(2 * kMargin, 2 * kMargin), Qt::KeepAspectRatio);
  const QRectF sheet(QPointF((width() - size.width()) / 2, kMargin), size);
  painter.fillRect(sheet.adjusted(-4, -4, 4, 4), Qt::white);
  renderer_.render(&painter, sheet);
}

}  // namespace desktop
