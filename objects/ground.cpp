#include "objects/ground.h"

#include <algorithm>
#include <cmath>

namespace objects {

namespace {

/// The plane through a point with a normal that is not level.
GroundPlane planeOf(const Vector3& point, const Vector3& normal) {
  const double slope_x = -normal[0] / normal[2], slope_y = -normal[1] / normal[2];
  return {slope_x, slope_y, point[2] - slope_x * point[0] - slope_y * point[1]};
}

std::optional<GroundPlane> through(const Vector3& a, const Vector3& b, const Vector3& c) {
  const Vector3 u{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  const Vector3 normal{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  const double size = std::hypot(normal[0], normal[1], normal[2]);
  if (!(std::abs(normal[2]) > 1e-6 * size) || size < 1e-9) return std::nullopt;  // upright, or on one line
  return planeOf(a, normal);
}

bool isLevelAndDeep(const GroundPlane& plane, const GroundFit& options) {
  return std::atan(std::hypot(plane.slope_x, plane.slope_y)) <= options.max_tilt_rad &&
         plane.height_m <= -options.least_depth_m;
}

bool isNear(const Vector3& point, const GroundPlane& plane, double tolerance_m) {
  return std::abs(point[2] - plane.at(point[0], point[1])) <= tolerance_m;
}

std::vector<std::size_t> nearPlane(std::span<const Vector3> points, const GroundPlane& plane, double tolerance_m) {
  std::vector<std::size_t> near;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (isNear(points[i], plane, tolerance_m)) near.push_back(i);
  }
  return near;
}

/// Means and second moments of points, about the means.
struct Moments {
  double n = 0, x = 0, y = 0, z = 0, xx = 0, xy = 0, yy = 0, xz = 0, yz = 0;

  Moments(std::span<const Vector3> points, std::span<const std::size_t> of) : n(static_cast<double>(of.size())) {
    for (const std::size_t i : of) {
      x += points[i][0] / n;
      y += points[i][1] / n;
      z += points[i][2] / n;
    }
    for (const std::size_t i : of) {
      const double dx = points[i][0] - x, dy = points[i][1] - y, dz = points[i][2] - z;
      xx += dx * dx / n;
      xy += dx * dy / n;
      yy += dy * dy / n;
      xz += dx * dz / n;
      yz += dy * dz / n;
    }
  }

  /// Standard deviation on the ground in the narrower of the principal directions.
  [[nodiscard]] double narrowSpread() const {
    const double middle = (xx + yy) / 2, radius = std::hypot((xx - yy) / 2, xy);
    return std::sqrt(std::max(0.0, middle - radius));
  }

  /// Least squares of the heights.
  [[nodiscard]] GroundPlane plane() const {
    const double determinant = xx * yy - xy * xy;
    const double slope_x = (xz * yy - yz * xy) / determinant, slope_y = (yz * xx - xz * xy) / determinant;
    return {slope_x, slope_y, z - slope_x * x - slope_y * y};
  }
};

Vector3 normalOf(const model::SceneObject& object, std::size_t axis) {
  const auto rows = object.pose.rotation();
  return {rows[0][axis], rows[1][axis], rows[2][axis]};
}

}  // namespace

void Ground::add(const GroundPlane& plane, const model::Pose& pose, const Vector3& half_extents) {
  patches_.push_back({.plane = plane, .ends = true, .pose = pose, .half_extents_m = half_extents});
}

std::optional<double> Ground::heightAt(double x_m, double y_m) const {
  std::optional<double> highest;
  for (const Patch& patch : patches_) {
    const double height = patch.plane.at(x_m, y_m);
    if (patch.ends) {
      const Vector3 local = patch.pose.toLocal({x_m, y_m, height});
      if (std::abs(local[1]) > patch.half_extents_m[1] || std::abs(local[2]) > patch.half_extents_m[2]) continue;
    }
    highest = std::max(highest.value_or(height), height);
  }
  return highest;
}

bool isGround(const model::SceneObject& object) {
  const double least = std::cos(kSteepestGround_rad);
  if (std::holds_alternative<model::Plane>(object.shape)) return std::abs(normalOf(object, 2)[2]) >= least;
  return std::holds_alternative<model::Rectangle>(object.shape) && std::abs(normalOf(object, 0)[2]) >= least;
}

Ground groundOf(const model::Scene& scene) {
  Ground ground;
  for (const model::SceneObject& object : scene.objects) {
    if (!isGround(object)) continue;
    if (std::holds_alternative<model::Plane>(object.shape)) {
      ground.add(planeOf(object.pose.position_m, normalOf(object, 2)));
    } else {
      ground.add(planeOf(object.pose.position_m, normalOf(object, 0)), object.pose, model::halfExtents(object.shape));
    }
  }
  return ground;
}

std::optional<GroundPlane> fitGround(std::span<const Vector3> points, const GroundFit& options, core::Random random) {
  if (points.size() < 3) return std::nullopt;
  const auto any = [&]() -> const Vector3& { return points[random.below(static_cast<std::uint32_t>(points.size()))]; };
  GroundPlane best_plane;
  std::ptrdiff_t most = 0;
  for (int i = 0; i < options.tries; ++i) {
    const Vector3 &a = any(), &b = any(), &c = any();
    const auto plane = through(a, b, c);
    if (!plane || !isLevelAndDeep(*plane, options)) continue;
    const auto near = std::count_if(points.begin(), points.end(),
                                    [&](const Vector3& p) { return isNear(p, *plane, options.tolerance_m); });
    if (near > most) {
      most = near;
      best_plane = *plane;
    }
  }
  if (most < 3) return std::nullopt;
  const std::vector<std::size_t> best = nearPlane(points, best_plane, options.tolerance_m);
  if (static_cast<double>(most) < options.least_share * static_cast<double>(points.size())) return std::nullopt;
  const Moments moments(points, best);
  if (moments.narrowSpread() < options.least_spread_m) return std::nullopt;
  const GroundPlane plane = moments.plane();
  return isLevelAndDeep(plane, options) ? std::optional(plane) : std::nullopt;
}

bool isOnGround(const Vector3& point, const Ground& ground, double tolerance_m) {
  const auto height = ground.heightAt(point[0], point[1]);
  return height && point[2] <= *height + tolerance_m;
}

}  // namespace objects
