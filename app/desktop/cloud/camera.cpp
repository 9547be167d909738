#include "app/desktop/cloud/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace desktop {

namespace {

constexpr double kHalfPi = std::numbers::pi / 2.0;
constexpr double kFieldOfView_rad = 40.0 * std::numbers::pi / 180.0;  // of the viewport's height
constexpr double kMargin = 0.07;                                      // of the viewport on each side, after fit()
constexpr double kNearest_m = 0.2;
constexpr double kFarthest_m = 1e5;

double focalOf(const QSizeF& viewport) { return 0.5 * viewport.height() / std::tan(0.5 * kFieldOfView_rad); }

}  // namespace

void Camera::look(double azimuth_rad, double down_rad) {
  azimuth_rad_ = std::remainder(azimuth_rad, 2.0 * std::numbers::pi);
  down_rad_ = std::clamp(down_rad, -kHalfPi, kHalfPi);
}

void Camera::orbit(double azimuth_rad, double down_rad) { look(azimuth_rad_ + azimuth_rad, down_rad_ + down_rad); }

Camera::Projector Camera::projector() const noexcept {
  const double ca = std::cos(azimuth_rad_);
  const double sa = std::sin(azimuth_rad_);
  const double cp = std::cos(down_rad_);
  const double sp = std::sin(down_rad_);
  Projector p{.right = {sa, -ca, 0.0},
              .up = {sp * ca, sp * sa, cp},
              .forward = {cp * ca, cp * sa, -sp},
              .eye = {},
              .centre_x = 0.5 * viewport_.width(),
              .centre_y = 0.5 * viewport_.height(),
              .focal_px = focalOf(viewport_),
              .fixed_depth_m = parallel_ ? distance_m_ : 0.0};
  p.eye = {target_.x - distance_m_ * p.forward[0], target_.y - distance_m_ * p.forward[1],
           target_.z - distance_m_ * p.forward[2]};
  if (parallel_) {
    // From far away, so that nothing is behind the eye: only the direction counts.
    p.eye = {target_.x - kFarthest_m * p.forward[0], target_.y - kFarthest_m * p.forward[1],
             target_.z - kFarthest_m * p.forward[2]};
  }
  return p;
}

Camera::Projected Camera::project(const Point3& point) const noexcept { return projector()(point.x, point.y, point.z); }

double Camera::pixelsPerMetre() const noexcept { return focalOf(viewport_) / distance_m_; }

void Camera::moveTarget(double right_px, double up_px) {
  const Projector p = projector();
  const double metres = 1.0 / pixelsPerMetre();
  target_.x += metres * (right_px * p.right[0] + up_px * p.up[0]);
  target_.y += metres * (right_px * p.right[1] + up_px * p.up[1]);
  target_.z += metres * (right_px * p.right[2] + up_px * p.up[2]);
}

void Camera::pan(QPointF pixels) { moveTarget(-pixels.x(), pixels.y()); }

void Camera::zoom(double factor, QPointF at) {
  const double wanted = std::clamp(distance_m_ / factor, kNearest_m, kFarthest_m);
  const double moved = 1.0 - wanted / distance_m_;
  moveTarget((at.x() - 0.5 * viewport_.width()) * moved, (0.5 * viewport_.height() - at.y()) * moved);
  distance_m_ = wanted;
}

/// On the screen; absent if one of the points is not in front of the eye.
std::optional<QRectF> Camera::boundsOf(std::span<const Point3> points) const {
  const Projector project = projector();
  double low_x = std::numeric_limits<double>::infinity();
  double low_y = low_x;
  double high_x = -low_x;
  double high_y = -low_x;
  for (const Point3& point : points) {
    const Projected at = project(point.x, point.y, point.z);
    if (!at.visible()) return std::nullopt;
    low_x = std::min(low_x, at.x);
    high_x = std::max(high_x, at.x);
    low_y = std::min(low_y, at.y);
    high_y = std::max(high_y, at.y);
  }
  return QRectF(low_x, low_y, high_x - low_x, high_y - low_y);
}

void Camera::fit(std::span<const Point3> points) {
  if (points.empty()) return;
  target_ = points.front();
  const QPointF centre(0.5 * viewport_.width(), 0.5 * viewport_.height());
  const double room_x = viewport_.width() * (1.0 - 2.0 * kMargin);
  const double room_y = viewport_.height() * (1.0 - 2.0 * kMargin);
  for (int round = 0; round < 8; ++round) {  // size and place depend on each other in perspective; this settles
    double near_log = std::log(kNearest_m);
    double far_log = std::log(kFarthest_m);
    for (int i = 0; i < 40; ++i) {  // the further, the smaller: halve the logarithm of the distance
      const double middle = 0.5 * (near_log + far_log);
      distance_m_ = std::exp(middle);
      const auto bounds = boundsOf(points);
      const bool fits = bounds && bounds->width() <= room_x && bounds->height() <= room_y;
      (fits ? far_log : near_log) = middle;
    }
    distance_m_ = std::exp(far_log);
    const auto bounds = boundsOf(points);
    if (bounds) moveTarget(bounds->center().x() - centre.x(), centre.y() - bounds->center().y());
  }
}

}  // namespace desktop
