#pragma once

#include <QGraphicsView>

namespace desktop {

/// Wheel and pinch zoom to the pointer, dragging moves, Ctrl+0 fits.
class GraphView final : public QGraphicsView {
  Q_OBJECT

 public:
  explicit GraphView(QWidget* parent = nullptr);

  void zoomBy(double factor);
  /// Everything in the window, but no smaller than `least` times its size; then the left end is shown.
  void fit(double least = 0.0);
  void reveal(QGraphicsItem* item);

 protected:
  void wheelEvent(QWheelEvent* event) override;
};

}  // namespace desktop
