#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/random.h"
#include "model/scene/scene.h"

namespace objects {

using model::Vector3;

/// A plane that is not upright: z = slope_x · x + slope_y · y + height. [m]
struct GroundPlane {
  double slope_x = 0.0;
  double slope_y = 0.0;
  double height_m = 0.0;  ///< below the sensor it is negative

  [[nodiscard]] double at(double x_m, double y_m) const { return slope_x * x_m + slope_y * y_m + height_m; }
};

/// What lies flat: planes without end, and boards that end.
class Ground {
 public:
  void add(const GroundPlane& plane) { patches_.push_back({.plane = plane}); }
  void add(const GroundPlane& plane, const model::Pose& pose, const Vector3& half_extents);

  [[nodiscard]] bool empty() const noexcept { return patches_.empty(); }
  /// Of the highest patch there, absent where there is none.
  [[nodiscard]] std::optional<double> heightAt(double x_m, double y_m) const;

 private:
  struct Patch {
    GroundPlane plane;
    bool ends = false;
    model::Pose pose{};        ///< of a board that ends
    Vector3 half_extents_m{};  ///< in its own frame
  };
  std::vector<Patch> patches_;
};

/// The steepest that still counts as ground.
inline constexpr double kSteepestGround_rad = 0.5235987755982988;  // 30°

/// True if the object is ground by reference: a plane, or a rectangle lying flat (normal within 30° of upright).
[[nodiscard]] bool isGround(const model::SceneObject& object);
[[nodiscard]] Ground groundOf(const model::Scene& scene);

struct GroundFit {
  double tolerance_m = 0.2;       ///< a detection so near, up or down, lies on the plane
  double max_tilt_rad = 0.17453;  ///< from level; 10°
  double least_share = 0.3;       ///< of the detections must lie on it
  double least_spread_m = 1.0;    ///< their standard deviation in the narrower direction: a wall's rows are lines
  double least_depth_m = 0.2;     ///< how far below the sensor it is at least
  int tries = 200;                ///< 200 find a plane that holds 30 % of the points with more than 99 %
};

/// The plane with most detections near it (random sample consensus), then the least-squares plane of these; absent if
/// none is good enough. The same points, order and random key give the same plane.
/// Source: Fischler & Bolles 1981, doi:10.1145/358669.358692 (RANSAC). Tilt, spread and depth limits are ours.
[[nodiscard]] std::optional<GroundPlane> fitGround(std::span<const Vector3> points, const GroundFit& options,
                                                   core::Random random);

/// True if the point lies at most `tolerance_m` above the ground, or anywhere below it: no object is there.
[[nodiscard]] bool isOnGround(const Vector3& point, const Ground& ground, double tolerance_m);

}  // namespace objects
