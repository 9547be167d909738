#include "app/desktop/cloud/cloud_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace desktop {

namespace {

const QColor kCanvas(0x12, 0x15, 0x1a);
const QColor kGrid(0x34, 0x3b, 0x45);
const QColor kGridText(0x8d, 0x98, 0xa5);
const QColor kText(0xe6, 0xe8, 0xeb);

constexpr double kPickReach_px = 9.0;
constexpr double kSpot = 0.25;  // detections whose radius is a smaller share of their distance are a spot
constexpr double kDegree = std::numbers::pi / 180.0;
constexpr std::array kAll{CloudSource::Measured, CloudSource::Simulated, CloudSource::Silent};

/// A line in space, without the part behind the eye.
void drawLine(QPainter& painter, const Camera& camera, const Point3& from, const Point3& to) {
  const auto a = camera.project(from);
  const auto b = camera.project(to);
  if (a.visible() && b.visible()) painter.drawLine(QPointF(a.x, a.y), QPointF(b.x, b.y));
}

/// Half the width of a point: few are shown large.
int radiusFor(std::size_t points) { return points > 200'000 ? 0 : points > 4'000 ? 1 : 2; }

}  // namespace

const QColor CloudView::kMeasured(0x56, 0xb4, 0xe9);
const QColor CloudView::kSimulated(0xf0, 0xa2, 0x1e);
const QColor CloudView::kSilent(0xcc, 0x79, 0xa7);

QColor CloudView::colourOf(CloudSource source) {
  return source == CloudSource::Measured ? kMeasured : source == CloudSource::Simulated ? kSimulated : kSilent;
}

CloudView::CloudView(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(240, 180);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setCursor(Qt::CrossCursor);
  look(Look::Perspective);
}

template <typename Visit>
void CloudView::eachShown(Visit visit) const {
  for (const CloudSource source : kAll) {
    const Side& shown = side(source);
    if (!shown.visible || !shown.cloud) continue;
    for (std::size_t i = 0; i < shown.cloud->size(); ++i) {
      if (shows(shown, i)) visit(source, shown, i);
    }
  }
}

void CloudView::setCloud(CloudSource source, std::shared_ptr<const PointCloud> cloud) {
  side(source).cloud = std::move(cloud);
  count();
  recolour();
  if (picked_ && picked_->source == source) pick(std::nullopt);
  if (fitted_) fit();
  update();
}

void CloudView::count() {
  for (Side& each : sides_) {
    each.shown = 0;
    for (std::size_t i = 0; each.cloud && i < each.cloud->size(); ++i) each.shown += shows(each, i);
  }
}

void CloudView::setPointSize(int pixels) {
  point_size_px_ = pixels;
  update();
}

void CloudView::setVisible(CloudSource source, bool visible) {
  side(source).visible = visible;
  if (picked_ && picked_->source == source && !visible) pick(std::nullopt);
  if (fitted_) fit();
  update();
}

void CloudView::setFrame(std::optional<int> frame) {
  frame_ = frame;
  count();
  if (picked_ && !shows(side(picked_->source), picked_->index)) pick(std::nullopt);
  update();
}

void CloudView::setColourBy(ColourBy by) {
  scale_.by = by;
  recolour();
  update();
}

void CloudView::setMessage(const QString& message) {
  message_ = message;
  update();
}

/// One scale for both sides and all frames, so that a colour means the same while frames go by. Beams without detection
/// keep their colour.
void CloudView::recolour() {
  std::array<std::vector<double>, 2> values;
  const auto& measured = side(CloudSource::Measured).cloud;
  const auto& simulated = side(CloudSource::Simulated).cloud;
  if (scale_.by == ColourBy::Difference) {
    if (measured && simulated) {
      values[0] = rangeDifferences(*measured, *simulated);
      values[1] = rangeDifferences(*simulated, *measured);
      for (double& value : values[1]) value = -value;  // always simulated minus measured
    }
  } else {
    if (measured) values[0] = valuesFor(*measured, scale_.by);
    if (simulated) values[1] = valuesFor(*simulated, scale_.by);
  }
  scale_ = scaleFor(scale_.by, values);
  for (std::size_t k = 0; k < 2; ++k) {
    sides_[k].values = std::move(values[k]);
    sides_[k].colours.clear();
    sides_[k].colours.reserve(sides_[k].values.size());
    for (const double value : sides_[k].values) sides_[k].colours.push_back(scale_(value));
  }
}

std::size_t CloudView::shownPoints() const {
  std::size_t count = 0;
  for (const Side& each : sides_) count += each.visible ? each.shown : 0;
  return count;
}

double CloudView::extent() const {
  double farthest = 1.0;
  for (const CloudSource source : {CloudSource::Measured, CloudSource::Simulated}) {
    const auto& cloud = side(source).cloud;
    for (const Point3& point : cloud ? cloud->outline : std::vector<Point3>()) {
      farthest = std::max(farthest, std::hypot(point.x, point.y));
    }
  }
  return farthest;
}

void CloudView::look(Look look) {
  camera_.setParallel(look != Look::Perspective);
  switch (look) {
    case Look::Perspective:
      camera_.look(-32 * kDegree, 26 * kDegree);
      break;
    case Look::Top:
      camera_.look(0, 90 * kDegree);
      break;
    case Look::Side:
      camera_.look(90 * kDegree, 0);
      break;
    case Look::Sensor:
      camera_.look(0, 0);
      break;
  }
  fit();
}

std::vector<Point3> CloudView::frameToFit() const {
  std::vector<Point3> frame;
  Point3 low{1e300, 1e300, 1e300};
  Point3 high{-1e300, -1e300, -1e300};
  for (const CloudSource source : kAll) {
    const Side& each = side(source);
    if (!each.cloud || !each.visible || each.cloud->size() == 0) continue;
    if (source == CloudSource::Silent && !frame.empty()) continue;  // they may go to the horizon
    for (auto point = each.cloud->outline.begin() + 1; point != each.cloud->outline.end(); ++point) {
      frame.push_back(*point);
      low = {std::min(low.x, point->x), std::min(low.y, point->y), std::min(low.z, point->z)};
      high = {std::max(high.x, point->x), std::max(high.y, point->y), std::max(high.z, point->z)};
    }
  }
  const double sensor_m = 0.02 * extent();  // a single beam is a line: give it some body
  const std::array<Point3, 2> sensor{Point3{0, sensor_m, sensor_m}, Point3{0, -sensor_m, -sensor_m}};
  if (frame.empty()) return {{0, -1, 0}, {0, 1, 0}, {2, 0, 0}};
  const Point3 centre{0.5 * (low.x + high.x), 0.5 * (low.y + high.y), 0.5 * (low.z + high.z)};
  const double distance_m = std::hypot(centre.x, centre.y, centre.z);
  const double radius_m = 0.5 * std::hypot(high.x - low.x, high.y - low.y, high.z - low.z);
  if (radius_m >= kSpot * distance_m) {
    frame.insert(frame.end(), sensor.begin(), sensor.end());
    return frame;
  }
  const double body_m = std::max(0.1 * distance_m, 1.5 * radius_m);  // what lies around tells where the spot is
  for (const double sign : {-1.0, 1.0}) {
    frame.push_back({centre.x + sign * body_m, centre.y, centre.z});
    frame.push_back({centre.x, centre.y + sign * body_m, centre.z});
    frame.push_back({centre.x, centre.y, centre.z + sign * body_m});
  }
  return frame;
}

void CloudView::fit() {
  camera_.setViewport(size());
  camera_.fit(frameToFit());
  fitted_ = true;
  update();
}

void CloudView::resizeEvent(QResizeEvent*) {
  camera_.setViewport(size());
  if (fitted_) fit();
}

void CloudView::pick(std::optional<PickedPoint> point) {
  if (point == picked_) return;
  picked_ = point;
  update();
  emit pickChanged();
}

QPointF CloudView::placeOf(PickedPoint point) const {
  const PointCloud& cloud = *side(point.source).cloud;
  const auto at = camera_.project({cloud.x[point.index], cloud.y[point.index], cloud.z[point.index]});
  return {at.x, at.y};
}

std::optional<PickedPoint> CloudView::pointAt(QPointF place) const { return nearestPoint(place, kPickReach_px); }

std::optional<PickedPoint> CloudView::nearestPoint(QPointF place, double reach_px) const {
  const Camera::Projector project = camera_.projector();
  std::optional<PickedPoint> nearest;
  double least = reach_px * reach_px;
  double depth = std::numeric_limits<double>::infinity();
  eachShown([&](CloudSource source, const Side& shown, std::size_t i) {
    const auto at = project(shown.cloud->x[i], shown.cloud->y[i], shown.cloud->z[i]);
    const double away = (at.x - place.x()) * (at.x - place.x()) + (at.y - place.y()) * (at.y - place.y());
    if (!at.visible() || away > least || (away == least && at.depth >= depth)) return;
    nearest = PickedPoint{source, i};
    least = away;
    depth = at.depth;
  });
  return nearest;
}

// Input -------------------------------------------------------------------------------------------------------------

void CloudView::mousePressEvent(QMouseEvent* event) {
  pressed_ = last_ = event->position();
  dragged_ = false;
}

void CloudView::mouseMoveEvent(QMouseEvent* event) {
  constexpr double kHand_px = 4.0;  // a hand that clicks is not quite still
  if (!dragged_ && (event->position() - pressed_).manhattanLength() < kHand_px) return;
  dragged_ = true;
  fitted_ = false;
  const QPointF moved = event->position() - last_;
  last_ = event->position();
  const bool turns = (event->buttons() & Qt::LeftButton) && !(event->modifiers() & Qt::ShiftModifier);
  constexpr double kTurn = 0.35 * kDegree;  // a pixel
  if (turns) {
    camera_.orbit(moved.x() * kTurn, moved.y() * kTurn);
  } else {
    camera_.pan(moved);
  }
  update();
}

void CloudView::mouseReleaseEvent(QMouseEvent* event) {
  if (!dragged_ && event->button() == Qt::LeftButton) pick(pointAt(event->position()));
}

void CloudView::mouseDoubleClickEvent(QMouseEvent* event) {
  const auto point = pointAt(event->position());
  if (!point) return;
  const PointCloud& cloud = *side(point->source).cloud;
  camera_.lookAt({cloud.x[point->index], cloud.y[point->index], cloud.z[point->index]});
  fitted_ = false;
  update();
}

void CloudView::wheelEvent(QWheelEvent* event) {
  camera_.zoom(std::pow(1.0015, event->angleDelta().y()), event->position());
  fitted_ = false;
  update();
  event->accept();
}

/// To the next shown point in the order of the file, from one source to the other, round and round.
void CloudView::step(int by) {
  std::vector<std::pair<CloudSource, const Side*>> shown;
  std::size_t place = 0;
  std::size_t total = 0;
  for (const CloudSource source : kAll) {
    const Side& each = side(source);
    if (!each.visible || !each.cloud) continue;
    if (picked_ && picked_->source == source) place = total + picked_->index;
    shown.emplace_back(source, &each);
    total += each.cloud->size();
  }
  if (shownPoints() == 0) return;
  if (!picked_) place = by > 0 ? total - 1 : 0;
  const auto found = [&]() -> std::optional<PickedPoint> {
    std::size_t left = place;
    for (const auto& [source, each] : shown) {
      if (left < each->cloud->size()) {
        return shows(*each, left) ? std::optional(PickedPoint{source, left}) : std::nullopt;
      }
      left -= each->cloud->size();
    }
    return std::nullopt;
  };
  for (std::size_t tries = 0; tries < total; ++tries) {
    place = by > 0 ? (place + 1) % total : (place + total - 1) % total;
    if (const auto point = found()) {
      pick(point);
      return;
    }
  }
}

void CloudView::turnOrMove(double right, double up, bool move) {
  constexpr double kStep = 5 * kDegree;
  constexpr double kMove_px = 40;
  if (move) {
    camera_.pan({-right * kMove_px, up * kMove_px});
  } else {
    camera_.orbit(right * kStep, up * kStep);
  }
}

void CloudView::keyPressEvent(QKeyEvent* event) {
  const bool move = event->modifiers() & Qt::ShiftModifier;
  const QPointF middle(0.5 * width(), 0.5 * height());
  if (event->matches(QKeySequence::Copy)) {
    emit copyRequested();
    return;
  }
  switch (event->key()) {
    case Qt::Key_Left:
      turnOrMove(-1, 0, move);
      break;
    case Qt::Key_Right:
      turnOrMove(1, 0, move);
      break;
    case Qt::Key_Up:
      turnOrMove(0, 1, move);
      break;
    case Qt::Key_Down:
      turnOrMove(0, -1, move);
      break;
    case Qt::Key_Plus:
      camera_.zoom(1.25, middle);
      break;
    case Qt::Key_Minus:
      camera_.zoom(0.8, middle);
      break;
    case Qt::Key_0:
      fit();
      return;
    case Qt::Key_1:
    case Qt::Key_2:
    case Qt::Key_3:
    case Qt::Key_4:
      look(Look(event->key() - Qt::Key_1));
      return;
    case Qt::Key_Space:
      pick(nearestPoint(middle, std::hypot(width(), height())));
      return;
    case Qt::Key_N:
      step(1);
      return;
    case Qt::Key_P:
      step(-1);
      return;
    case Qt::Key_Escape:
      pick(std::nullopt);
      return;
    default:
      QWidget::keyPressEvent(event);
      return;
  }
  fitted_ = false;
  update();
}

// Drawing -----------------------------------------------------------------------------------------------------------

bool CloudView::nothingToShow() const {
  return std::none_of(sides_.begin(), sides_.end(), [](const Side& s) { return s.cloud && s.cloud->size() > 0; });
}

void CloudView::paintEvent(QPaintEvent*) {
  const double ratio = devicePixelRatioF();
  const QSize pixels = size() * ratio;
  if (canvas_.size() != pixels) canvas_ = QImage(pixels, QImage::Format_RGB32);
  canvas_.setDevicePixelRatio(ratio);
  canvas_.fill(kCanvas);
  {
    QPainter ground(&canvas_);
    ground.setRenderHint(QPainter::Antialiasing);
    if (!nothingToShow()) drawGround(ground);
  }
  if (!nothingToShow()) drawPoints();
  QPainter painter(this);
  painter.drawImage(0, 0, canvas_);
  painter.setRenderHint(QPainter::Antialiasing);
  if (nothingToShow()) {
    painter.setPen(kText);
    painter.drawText(rect().adjusted(40, 40, -40, -40), Qt::AlignCenter | Qt::TextWordWrap, message_);
    return;
  }
  drawPick(painter);
  drawLegend(painter);
  drawHint(painter);
}

void CloudView::drawGround(QPainter& painter) const {
  const double reach = extent();
  const double step = roundStep(reach / 5.0);
  const int rings = int(std::ceil(reach / step - 1e-9));
  constexpr int kPieces = 180;
  const auto on = [](double radius, double angle) {
    return Point3{radius * std::cos(angle), radius * std::sin(angle), 0.0};
  };
  painter.setPen(QPen(kGrid, 1));
  for (int ring = 1; ring <= rings; ++ring) {
    for (int k = 0; k < kPieces; ++k) {
      const double angle = 2.0 * std::numbers::pi / kPieces;
      drawLine(painter, camera_, on(ring * step, k * angle), on(ring * step, (k + 1) * angle));
    }
  }
  for (int k = 0; k < 12; ++k) {
    for (int ring = 0; ring < rings; ++ring) {  // piece by piece: only those behind the eye are left out
      drawLine(painter, camera_, on(ring * step, k * 30 * kDegree), on((ring + 1) * step, k * 30 * kDegree));
    }
  }
  painter.setPen(kGridText);
  for (int ring = 1; ring <= rings; ++ring) {
    const auto at = camera_.project(on(ring * step, 0.0));
    if (at.visible()) painter.drawText(QPointF(at.x + 4, at.y - 3), QString::number(ring * step) + " m");
  }
  const auto sensor = camera_.project({});
  if (!sensor.visible()) return;
  painter.setPen(QPen(kText, 1.5));
  painter.setBrush(kCanvas);
  painter.drawEllipse(QPointF(sensor.x, sensor.y), 4.5, 4.5);
  painter.drawText(QPointF(sensor.x + 9, sensor.y + 4), tr("sensor"));
}

void CloudView::splat(int x, int y, float depth, QRgb colour, CloudSource source, int radius) {
  const auto put = [&](int px, int py) {
    if (px < 0 || py < 0 || px >= canvas_.width() || py >= canvas_.height()) return;
    float& nearest = depths_[std::size_t(py) * std::size_t(canvas_.width()) + std::size_t(px)];
    if (depth > nearest) return;
    nearest = depth;
    reinterpret_cast<QRgb*>(canvas_.scanLine(py))[px] = colour;
  };
  if (source == CloudSource::Simulated && radius > 0) {  // a cross
    for (int k = -radius; k <= radius; ++k) {
      put(x + k, y);
      put(x, y + k);
    }
    return;
  }
  if (source == CloudSource::Silent && radius > 0) {  // a diagonal cross
    for (int k = -radius; k <= radius; ++k) {
      put(x + k, y + k);
      put(x + k, y - k);
    }
    return;
  }
  for (int dy = -radius; dy <= radius; ++dy) {
    for (int dx = -radius; dx <= radius; ++dx) put(x + dx, y + dy);
  }
}

void CloudView::drawPoints() {
  depths_.assign(std::size_t(canvas_.width()) * std::size_t(canvas_.height()), std::numeric_limits<float>::infinity());
  const double ratio = devicePixelRatioF();
  const double wanted = point_size_px_ > 0 ? 0.5 * (point_size_px_ - 1) : radiusFor(shownPoints());
  const int radius = std::max(int(std::lround(wanted * ratio)), ratio > 1.5 ? 1 : 0);
  const Camera::Projector project = camera_.projector();
  eachShown([&](CloudSource source, const Side& shown, std::size_t i) {
    const auto at = project(shown.cloud->x[i], shown.cloud->y[i], shown.cloud->z[i]);
    const double x = at.x * ratio;
    const double y = at.y * ratio;
    if (!at.visible() || x < -8 || y < -8 || x > canvas_.width() + 8 || y > canvas_.height() + 8) return;
    const QRgb own = colourOf(source).rgb();
    const QRgb colour = i < shown.colours.size() ? shown.colours[i] : own;
    // A cross on a square leaves both to be seen; so it lies on top unless something else is clearly in front.
    const double depth = source == CloudSource::Simulated ? 0.98 * at.depth : at.depth;
    splat(int(std::lround(x)), int(std::lround(y)), float(depth), colour, source, radius);
  });
}

void CloudView::drawPick(QPainter& painter) const {
  if (!picked_) return;
  const QPointF at = placeOf(*picked_);
  const auto sensor = camera_.project({});
  if (sensor.visible()) {  // the beam
    painter.setPen(QPen(QColor(255, 255, 255, 110), 1, Qt::DashLine));
    painter.drawLine(QPointF(sensor.x, sensor.y), at);
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(kCanvas, 4));
  painter.drawEllipse(at, 8, 8);
  painter.setPen(QPen(Qt::white, 2));
  painter.drawEllipse(at, 8, 8);
}

void CloudView::drawLegend(QPainter& painter) const {
  const QFontMetrics metrics(font());
  const int line = metrics.lineSpacing() + 4;
  std::vector<std::pair<CloudSource, QString>> entries;
  for (const CloudSource source : kAll) {
    const Side& shown = side(source);
    if (!shown.cloud || !shown.visible) continue;
    const QString word = source == CloudSource::Measured    ? tr("Measured")
                         : source == CloudSource::Simulated ? tr("Simulated")
                                                            : tr("No detection");
    entries.emplace_back(source, tr("%1 (%L2)").arg(word).arg(qulonglong(shown.shown)));
  }
  int widest = 0;
  for (const auto& entry : entries) widest = std::max(widest, metrics.horizontalAdvance(entry.second));
  const bool ramp = scale_.by != ColourBy::Source;
  if (ramp) widest = std::max(widest, metrics.horizontalAdvance(titleOf(scale_.by)) - 20);
  const double height = double(entries.size()) * line + 14 + (ramp ? 150 + line : 0);
  const QRectF box(width() - widest - 56.0, 12, widest + 44.0, height);
  painter.setPen(QPen(kGrid, 1));
  painter.setBrush(QColor(0x1c, 0x20, 0x27, 225));
  painter.drawRoundedRect(box, 6, 6);
  double y = box.top() + 7;
  for (const auto& [source, text] : entries) {
    const QPointF sign(box.left() + 16, y + 0.5 * line);
    const QColor colour = ramp && source != CloudSource::Silent ? kText : colourOf(source);
    if (source == CloudSource::Measured) {
      painter.fillRect(QRectF(sign.x() - 4, sign.y() - 4, 8, 8), colour);
    } else {
      const bool upright = source == CloudSource::Simulated;
      const QPointF one = upright ? QPointF(5, 0) : QPointF(4, 4);
      const QPointF two = upright ? QPointF(0, 5) : QPointF(4, -4);
      painter.setPen(QPen(colour, 2));
      painter.drawLine(sign - one, sign + one);
      painter.drawLine(sign - two, sign + two);
    }
    painter.setPen(kText);
    painter.drawText(QRectF(box.left() + 30, y, box.width() - 34, line), Qt::AlignVCenter, text);
    y += line;
  }
  if (ramp) drawRamp(painter, QRectF(box.left(), y, box.width(), box.bottom() - y));
}

void CloudView::drawRamp(QPainter& painter, const QRectF& box) const {
  const int line = QFontMetrics(font()).lineSpacing() + 4;
  painter.setPen(kText);
  painter.drawText(QRectF(box.left() + 10, box.top(), box.width() - 12, line), Qt::AlignVCenter, titleOf(scale_.by));
  if (!scale_.known) {
    painter.setPen(kGridText);
    painter.drawText(box.adjusted(10, line, -6, 0), Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap,
                     scale_.by == ColourBy::Difference ? tr("No beam has both a measured and a simulated detection.")
                                                       : tr("not recorded"));
    return;
  }
  const QRectF bar(box.left() + 12, box.top() + line + 8, 14, box.height() - line - 24);
  QLinearGradient gradient(bar.bottomLeft(), bar.topLeft());
  for (int k = 0; k <= 16; ++k) gradient.setColorAt(k / 16.0, scale_.at(k / 16.0));
  painter.setPen(Qt::NoPen);
  painter.setBrush(gradient);
  painter.drawRoundedRect(bar, 2, 2);
  painter.setPen(kText);
  for (const double tick : scale_.ticks()) {
    const double y = bar.bottom() - scale_.shareOf(tick) * bar.height();
    painter.drawLine(QPointF(bar.right() + 2, y), QPointF(bar.right() + 6, y));
    painter.drawText(QRectF(bar.right() + 10, y - 10, box.width(), 20), Qt::AlignVCenter,
                     QString::number(tick, 'g', 4));
  }
}

void CloudView::drawHint(QPainter& painter) const {
  painter.setPen(kGridText);
  const QString hint = tr("Drag turns · right drag moves · wheel zooms · click picks · N, P: next, previous · 0 fits");
  painter.drawText(rect().adjusted(14, 0, -14, -10), Qt::AlignLeft | Qt::AlignBottom,
                   QFontMetrics(font()).elidedText(hint, Qt::ElideRight, width() - 28));
}

}  // namespace desktop
