#pragma once

#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <optional>
#include <span>

namespace desktop {

/// ISO 8855, sensor at the origin: x forward, y left, z up. [m]
struct Point3 {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};

/// An eye that circles a target.
///
///   forward  (cos p cos a, cos p sin a, -sin p)     a  azimuth it looks to, 0: along x, positive to the left
///   right    (sin a, -cos a, 0)                     p  how far down it looks, 90 degrees: from above, x is up
///   up       (sin p cos a, sin p sin a, cos p)
///
///   screen = centre + focal / depth * (v . right, -v . up),   v = point - eye, depth = v . forward
///
/// `parallel` takes the target's depth for every point: a map without foreshortening, true to scale.
class Camera {
 public:
  void setViewport(QSizeF pixels) { viewport_ = pixels; }
  void setParallel(bool parallel) { parallel_ = parallel; }
  [[nodiscard]] bool parallel() const noexcept { return parallel_; }
  void look(double azimuth_rad, double down_rad);
  void lookAt(const Point3& target) { target_ = target; }

  void orbit(double azimuth_rad, double down_rad);  ///< by these angles; never over the top
  void pan(QPointF pixels);                         ///< what is at the target's depth follows the pointer
  void zoom(double factor, QPointF at);             ///< what is at the target's depth under `at` stays there
  /// All points in the viewport, as large as a margin allows. Keeps the direction.
  void fit(std::span<const Point3> points);

  struct Projected {
    double x;      ///< [pixel]
    double y;      ///< [pixel], downwards
    double depth;  ///< along the line of sight [m]; behind the eye: nothing of it is seen
    [[nodiscard]] bool visible() const noexcept { return depth > kNear_m; }
  };
  [[nodiscard]] Projected project(const Point3& point) const noexcept;

  static constexpr double kNear_m = 0.05;

  /// The same with everything that does not depend on the point taken out, for clouds.
  struct Projector {
    double right[3];
    double up[3];
    double forward[3];
    Point3 eye;
    double centre_x;
    double centre_y;
    double focal_px;
    double fixed_depth_m;  ///< 0: perspective

    [[nodiscard]] Projected operator()(double x, double y, double z) const noexcept {
      const double vx = x - eye.x;
      const double vy = y - eye.y;
      const double vz = z - eye.z;
      const double depth = vx * forward[0] + vy * forward[1] + vz * forward[2];
      const double scale = focal_px / (fixed_depth_m > 0.0 ? fixed_depth_m : depth);
      return {centre_x + scale * (vx * right[0] + vy * right[1] + vz * right[2]),
              centre_y - scale * (vx * up[0] + vy * up[1] + vz * up[2]), depth};
    }
  };
  [[nodiscard]] Projector projector() const noexcept;
  /// Pixels that one metre takes at the target. [1/m]
  [[nodiscard]] double pixelsPerMetre() const noexcept;

 private:
  void moveTarget(double right_px, double up_px);
  [[nodiscard]] std::optional<QRectF> boundsOf(std::span<const Point3> points) const;

  QSizeF viewport_{100, 100};
  Point3 target_;
  double azimuth_rad_ = 0.0;
  double down_rad_ = 0.5;
  double distance_m_ = 30.0;
  bool parallel_ = false;
};

}  // namespace desktop
