#pragma once

#include <QImage>
#include <QWidget>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "app/desktop/cloud/camera.h"
#include "app/desktop/cloud/colour_scale.h"
#include "app/desktop/cloud/point_cloud.h"

namespace desktop {

/// One detection of one cloud.
struct PickedPoint {
  CloudSource source;
  std::size_t index;
  bool operator==(const PickedPoint&) const = default;
};

/// Points in space on a dark canvas, measured ones as squares, simulated ones as crosses, beams without detection as
/// diagonal crosses; the sensor at the origin, rings of range on its ground, a legend. Drawn point by point with a
/// depth buffer: a million stay smooth.
///
/// Left drag turns, right drag or Shift moves, the wheel zooms to the pointer, a click picks, a double click makes the
/// point the centre. Keys: arrows turn, with Shift they move, + and - zoom, 0 fits, 1 to 4 choose a look;
/// Space picks the point nearest to the middle, N and P the next and the one before, Escape forgets the pick.
class CloudView final : public QWidget {
  Q_OBJECT

 public:
  explicit CloudView(QWidget* parent = nullptr);

  /// Null: nothing of this source. Keeps the camera unless it fits; forgets a pick of this source.
  void setCloud(CloudSource source, std::shared_ptr<const PointCloud> cloud);
  void setVisible(CloudSource source, bool visible);
  using QWidget::setVisible;
  void setFrame(std::optional<int> frame);  ///< none: all frames
  void setColourBy(ColourBy by);
  void setPointSize(int pixels);            ///< 0: as many points ask for
  void setMessage(const QString& message);  ///< in the middle, while there is nothing to show
  [[nodiscard]] const QString& message() const noexcept { return message_; }

  enum class Look { Perspective, Top, Side, Sensor };
  void look(Look look);  ///< and fit
  /// What is shown fills the window. The sensor is in it too, unless the detections are a small spot far from it.
  void fit();
  [[nodiscard]] bool isFitted() const noexcept { return fitted_; }

  void pick(std::optional<PickedPoint> point);
  [[nodiscard]] std::optional<PickedPoint> picked() const noexcept { return picked_; }
  /// The shown point nearest to a place of the widget, at most some pixels away; of several the one in front.
  [[nodiscard]] std::optional<PickedPoint> pointAt(QPointF place) const;
  [[nodiscard]] std::optional<PickedPoint> nearestPoint(QPointF place, double reach_px) const;
  [[nodiscard]] QPointF placeOf(PickedPoint point) const;
  [[nodiscard]] const Camera& camera() const noexcept { return camera_; }
  [[nodiscard]] std::size_t shownPoints() const;

  [[nodiscard]] QSize sizeHint() const override { return {900, 600}; }

  static const QColor kMeasured;
  static const QColor kSimulated;
  static const QColor kSilent;
  [[nodiscard]] static QColor colourOf(CloudSource source);

 signals:
  void pickChanged();
  void copyRequested();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct Side {
    std::shared_ptr<const PointCloud> cloud;
    std::vector<double> values;  ///< of what the colour tells
    std::vector<QRgb> colours;   ///< one for each point; empty: the source's
    std::size_t shown = 0;       ///< points of the chosen frames, whether visible or not
    bool visible = true;
  };
  [[nodiscard]] Side& side(CloudSource source) { return sides_[std::size_t(source)]; }
  [[nodiscard]] const Side& side(CloudSource source) const { return sides_[std::size_t(source)]; }
  [[nodiscard]] bool shows(const Side& side, std::size_t i) const {
    return !frame_ || side.cloud->detections.frame[i] == *frame_;
  }
  template <typename Visit>
  void eachShown(Visit visit) const;
  void recolour();
  void count();
  void step(int by);
  void turnOrMove(double right, double up, bool move);
  [[nodiscard]] std::vector<Point3> frameToFit() const;
  [[nodiscard]] double extent() const;
  void drawGround(QPainter& painter) const;
  void drawPoints();
  void splat(int x, int y, float depth, QRgb colour, CloudSource source, int radius);
  void drawPick(QPainter& painter) const;
  void drawLegend(QPainter& painter) const;
  void drawRamp(QPainter& painter, const QRectF& box) const;
  void drawHint(QPainter& painter) const;
  [[nodiscard]] bool nothingToShow() const;

  std::array<Side, 3> sides_;
  std::optional<int> frame_;
  int point_size_px_ = 0;
  ColourScale scale_;
  Camera camera_;
  std::optional<PickedPoint> picked_;
  QString message_;
  QImage canvas_;
  std::vector<float> depths_;
  QPointF last_;
  QPointF pressed_;
  bool dragged_ = false;
  bool fitted_ = false;  ///< the camera fits the cloud and follows the size of the widget until somebody moves it
};

}  // namespace desktop
