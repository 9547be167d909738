#pragma once

#include <algorithm>
#include <cmath>

namespace model {

/// Where light comes from and where it goes, both as directions away from the surface.
///
///        out  normal  in          cos_in, cos_out   of the angles to the normal, in (0, 1]
///          \    |    /            cos_azimuth       of the angle between both, projected onto the surface:
///           \   |   /                               1 towards the light (where a lidar sits), -1 the mirror's side
///       _____\__|__/_____
///
/// A BRDF is a function of these, in 1/sr; it does not change when `in` and `out` change places (Helmholtz).
struct ReflectionAngles {
  double cos_in = 1.0;
  double cos_out = 1.0;
  double cos_azimuth = 1.0;

  /// Back to where the light came from.
  [[nodiscard]] static ReflectionAngles monostatic(double cos_incidence) { return {cos_incidence, cos_incidence, 1.0}; }

  [[nodiscard]] double sinProduct() const {
    return std::sqrt(std::max(0.0, (1.0 - cos_in * cos_in) * (1.0 - cos_out * cos_out)));
  }
  /// Cosine of the angle between both directions; 1 if monostatic.
  [[nodiscard]] double cosBetween() const {
    return std::clamp(cos_in * cos_out + sinProduct() * cos_azimuth, -1.0, 1.0);
  }
  /// Cosine of the angle between `out` and the mirror direction of `in`; cos 2θ if monostatic.
  [[nodiscard]] double cosToMirror() const {
    return std::clamp(cos_in * cos_out - sinProduct() * cos_azimuth, -1.0, 1.0);
  }
};

}  // namespace model
