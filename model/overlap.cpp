#include "model/overlap.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace model {

namespace {

/// Area that two circles share, as a share of the first one's.
double sharedArea(double radius, double other, double distance) {
  if (distance >= radius + other) return 0.0;
  if (distance <= other - radius) return 1.0;
  if (distance <= radius - other) return other * other / (radius * radius);
  const double a = std::acos((distance * distance + radius * radius - other * other) / (2.0 * distance * radius));
  const double b = std::acos((distance * distance + other * other - radius * radius) / (2.0 * distance * other));
  const double area = radius * radius * (a - 0.5 * std::sin(2.0 * a)) + other * other * (b - 0.5 * std::sin(2.0 * b));
  return area / (std::numbers::pi * radius * radius);
}

double widthOf(const AngularSize& size) { return size.horizontal_rad > 0.0 ? size.horizontal_rad : size.vertical_rad; }

}  // namespace

double overlap(const Emitter& emitter, const Receiver& receiver, double range_m) {
  const double half_view_rad = widthOf(receiver.field_of_view) / 2.0;
  if (half_view_rad == 0.0) return 1.0;
  const double spot_m = std::max(1e-6, range_m * (widthOf(emitter.divergence) / 2.0));
  return sharedArea(spot_m, receiver.aperture_diameter_m / 2.0 + range_m * half_view_rad, receiver.axis_offset_m);
}

}  // namespace model
