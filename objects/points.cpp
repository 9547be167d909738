#include "objects/points.h"

#include <cmath>

namespace objects {

std::vector<Vector3> pointsOf(const core::Detections& detections) {
  std::vector<Vector3> points(detections.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double on_ground_m = detections.range_m[i] * std::cos(detections.elevation_rad[i]);
    points[i] = {on_ground_m * std::cos(detections.azimuth_rad[i]), on_ground_m * std::sin(detections.azimuth_rad[i]),
                 detections.range_m[i] * std::sin(detections.elevation_rad[i])};
  }
  return points;
}

}  // namespace objects
