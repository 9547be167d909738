#include "app/desktop/graph_view.h"

#include <QGraphicsItem>
#include <QScrollBar>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace desktop {

GraphView::GraphView(QWidget* parent) : QGraphicsView(parent) {
  setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  setDragMode(ScrollHandDrag);
  setTransformationAnchor(AnchorUnderMouse);
  setViewportUpdateMode(SmartViewportUpdate);
  setBackgroundRole(QPalette::Base);
  setFrameShape(NoFrame);
}

void GraphView::zoomBy(double factor) {
  const double now = transform().m11();
  const double wanted = std::clamp(now * factor, 0.05, 4.0);
  scale(wanted / now, wanted / now);
}

void GraphView::fit(double least) {
  if (!scene() || scene()->sceneRect().isEmpty()) return;
  const QRectF area = scene()->sceneRect();
  const double whole = std::min(viewport()->width() / area.width(), viewport()->height() / area.height());
  const double factor = std::clamp(whole, std::max(0.05, least), 1.15);
  setTransform(QTransform::fromScale(factor, factor));
  centerOn(area.center());
  if (factor > whole) horizontalScrollBar()->setValue(horizontalScrollBar()->minimum());
}

void GraphView::reveal(QGraphicsItem* item) {
  if (transform().m11() < 0.5) setTransform(QTransform::fromScale(0.7, 0.7));
  const QRectF shown = mapToScene(viewport()->rect()).boundingRect().adjusted(20, 20, -20, -20);
  if (!shown.contains(item->sceneBoundingRect())) centerOn(item);
}

void GraphView::wheelEvent(QWheelEvent* event) {
  zoomBy(std::pow(1.0015, event->angleDelta().y()));
  event->accept();
}

}  // namespace desktop
