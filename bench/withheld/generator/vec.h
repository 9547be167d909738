#pragma once

#include <array>
#include <cmath>
#include <numbers>

namespace withheld {

constexpr double kLight_m_ns = 0.299792458;
constexpr double kDegree = std::numbers::pi / 180.0;

/// A vector in ISO 8855 axes: x forward, y left, z up.
struct Vec {
  double x = 0.0, y = 0.0, z = 0.0;

  friend Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec operator*(double k, Vec a) { return {k * a.x, k * a.y, k * a.z}; }
};

inline double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline double length(Vec a) { return std::sqrt(dot(a, a)); }
inline Vec unit(Vec a) { return (1.0 / length(a)) * a; }

/// Unit vector of azimuth (to the left) and elevation (up). [rad]
inline Vec direction(double azimuth_rad, double elevation_rad) {
  const double c = std::cos(elevation_rad);
  return {c * std::cos(azimuth_rad), c * std::sin(azimuth_rad), std::sin(elevation_rad)};
}

/// Rz(yaw) · Ry(pitch) · Rx(roll): the columns are the local axes seen from outside.
struct Turn {
  Vec ex{1, 0, 0}, ey{0, 1, 0}, ez{0, 0, 1};

  static Turn yawPitchRoll(double yaw, double pitch, double roll) {
    const double cy = std::cos(yaw), sy = std::sin(yaw), cp = std::cos(pitch), sp = std::sin(pitch);
    const double cr = std::cos(roll), sr = std::sin(roll);
    return {{cy * cp, sy * cp, -sp},
            {cy * sp * sr - sy * cr, sy * sp * sr + cy * cr, cp * sr},
            {cy * sp * cr + sy * sr, sy * sp * cr - cy * sr, cp * cr}};
  }
  [[nodiscard]] Vec outward(Vec v) const { return v.x * ex + v.y * ey + v.z * ez; }
  [[nodiscard]] Vec inward(Vec v) const { return {dot(v, ex), dot(v, ey), dot(v, ez)}; }
};

}  // namespace withheld
