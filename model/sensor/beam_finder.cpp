#include "model/sensor/beam_finder.h"

#include <algorithm>
#include <cmath>

namespace model {

namespace {

/// Rounding of directions that went through single precision, or a text.
constexpr double kSlack_rad = 1e-5;

/// Three cell numbers, each less than 2²⁰ in size, as one.
std::uint64_t keyOf(std::int64_t x, std::int64_t y, std::int64_t z) {
  constexpr std::int64_t kMiddle = 1 << 20;
  constexpr int kBits = 21;
  const auto word = [](std::int64_t cell) { return static_cast<std::uint64_t>(cell + kMiddle); };
  return (word(x) << (2 * kBits)) | (word(y) << kBits) | word(z);
}

/// Offsets of a direction in the beam's own plane; behind the sensor there is none.
std::optional<PlaceInBeam> placeIn(const Beam& beam, const Vector3& d) {
  const double ca = std::cos(beam.azimuth_rad), sa = std::sin(beam.azimuth_rad);
  const double ce = std::cos(beam.elevation_rad), se = std::sin(beam.elevation_rad);
  const double forward = ce * ca * d[0] + ce * sa * d[1] + se * d[2];
  if (forward <= 0.0) return std::nullopt;
  return PlaceInBeam{.left_rad = std::atan2(-sa * d[0] + ca * d[1], forward),
                     .up_rad = std::atan2(-se * ca * d[0] - se * sa * d[1] + ce * d[2], forward)};
}

}  // namespace

BeamFinder::BeamFinder(std::span<const Beam> beams, double half_left_rad, double half_up_rad)
    : beams_(beams),
      half_left_rad_(half_left_rad + kSlack_rad),
      half_up_rad_(half_up_rad + kSlack_rad),
      // No chord is longer than the sum of the angles' tangents: what a beam reaches lies in its own cell or beside it.
      cell_(std::tan(half_left_rad_) + std::tan(half_up_rad_)) {
  for (std::uint32_t b = 0; b < beams.size(); ++b) {
    const Vector3 axis = directionOf(beams[b], 0.0, 0.0);
    beams_in_[keyOf(cellOf(axis[0]), cellOf(axis[1]), cellOf(axis[2]))].push_back(b);
  }
}

std::int64_t BeamFinder::cellOf(double along) const { return static_cast<std::int64_t>(std::floor(along / cell_)); }

std::optional<PlaceInBeam> BeamFinder::find(const Vector3& direction) const {
  std::optional<PlaceInBeam> nearest;
  double least = 0.0;
  const std::int64_t x = cellOf(direction[0]), y = cellOf(direction[1]), z = cellOf(direction[2]);
  for (std::int64_t neighbour = 0; neighbour < 27; ++neighbour) {
    const auto found = beams_in_.find(keyOf(x + neighbour % 3 - 1, y + neighbour / 3 % 3 - 1, z + neighbour / 9 - 1));
    if (found == beams_in_.end()) continue;
    for (const std::uint32_t b : found->second) {
      std::optional<PlaceInBeam> place = placeIn(beams_[b], direction);
      if (!place || std::abs(place->left_rad) > half_left_rad_ || std::abs(place->up_rad) > half_up_rad_) continue;
      const double apart = std::hypot(place->left_rad, place->up_rad);
      if (nearest && (apart > least || (apart == least && b > nearest->beam))) continue;
      place->beam = b;
      nearest = place;
      least = apart;
    }
  }
  return nearest;
}

}  // namespace model
