#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "model/sensor/beams.h"

namespace model {

/// Where in which beam a direction lies.
struct PlaceInBeam {
  std::uint32_t beam = 0;
  double left_rad = 0.0;  ///< as in SubRays
  double up_rad = 0.0;
};

/// Finds the beam that lights up a direction. A beam is taken to reach `half_left_rad` to both sides of its axis and
/// `half_up_rad` above and below; where beams overlap, the nearest axis counts. The beams must outlive it.
class BeamFinder {
 public:
  BeamFinder(std::span<const Beam> beams, double half_left_rad, double half_up_rad);

  /// Nothing if no beam reaches there. `direction` has unit length.
  [[nodiscard]] std::optional<PlaceInBeam> find(const Vector3& direction) const;

 private:
  [[nodiscard]] std::int64_t cellOf(double along) const;

  std::span<const Beam> beams_;
  double half_left_rad_;
  double half_up_rad_;
  double cell_;  ///< edge of the cells into which the axes' ends are sorted
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> beams_in_;
};

}  // namespace model
