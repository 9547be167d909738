#pragma once

#include <span>

namespace metrics {

/// A place in a Cartesian frame that both sides share. [m]
struct Position {
  double x_m = 0.0;
  double y_m = 0.0;
  double z_m = 0.0;
};

/// Euclidean. [m]
[[nodiscard]] double distance(const Position& a, const Position& b) noexcept;

/// Points in any order; the two sides may differ in number. Referred to, not owned.
struct CloudPair {
  std::span<const Position> simulated;
  std::span<const Position> measured;
};

/// Throws InputError that names side and row (from 1) if a coordinate is not finite.
void mustBeFinite(const CloudPair& clouds);

/// The same, and both sides must have a point: there is no distance to nothing.
void mustHavePoints(const CloudPair& clouds);

}  // namespace metrics
