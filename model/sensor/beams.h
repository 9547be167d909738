#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "model/scene/pose.h"
#include "model/sensor/sensor_profile.h"

namespace model {

/// One shot of the scan: where it points and when it is fired within the frame.
struct Beam {
  std::int32_t layer = 0;
  std::int32_t column = 0;  ///< counted within the layer from `azimuth_from_deg` on
  double azimuth_rad = 0.0;
  double elevation_rad = 0.0;
  double time_s = 0.0;        ///< since the start of the frame
  double gain = 1.0;          ///< share of the emitter's peak power that goes out here, at the beam's centre
  double scene_time_s = 0.0;  ///< at which the scene is met; 0 unless an effect sets it
};

/// Direction of a beam's axis turned by angular offsets to the left and up in the beam's own plane; unit length.
[[nodiscard]] Vector3 directionOf(const Beam& beam, double left_rad, double up_rad);

/// What `directionOf` needs of a beam, worked out once for many sub-rays.
struct BeamTurn {
  explicit BeamTurn(const Beam& beam);
  /// `directionOf` for tangents of the offsets.
  [[nodiscard]] Vector3 directionAt(double left_slope, double up_slope) const;

  double cos_azimuth, sin_azimuth, cos_elevation, sin_elevation;
};

/// The beams of one frame, layer by layer, columns from `azimuth_from_deg` on (formats.md section 2): column k of n in
/// order of firing is fired at t = k/n · duty / frame_rate, plus the layer's offset; the direction of the scan alone
/// decides the order. A flash fires all columns at the layer's offset. Along a Lissajous figure (scan.h) every way of
/// the mirror is a layer, with its columns in order of firing.
[[nodiscard]] std::vector<Beam> beamsOf(const Scan& scan);

/// Directions given point by point: CSV layer,azimuth_rad,elevation_rad[,time_s].
[[nodiscard]] std::vector<Beam> readBeams(const std::filesystem::path& file);

/// Gives beams that were read point by point the gain that the scan has at their layer and azimuth.
void applyGain(const Scan& scan, std::span<Beam> beams);

/// Angular offsets over the beam's cross-section with their weights (sum 1), formats.md section 3, step 1.
struct SubRays {
  std::vector<double> left_rad;  ///< offset to the left in the beam's own plane
  std::vector<double> up_rad;
  std::vector<double> weight;  ///< share of the beam's power

  [[nodiscard]] std::size_t size() const noexcept { return weight.size(); }
  /// Returns the index of the new one.
  std::uint32_t add(double left, double up, double share);
};

/// How the sub-rays lie: in the even grid of the reference chain, or in the same grid sheared by less than a step, so
/// that no two rays share a height or a side: the share of a beam that an upright edge cuts off is then right to about
/// one in the number of all rays, not of the rays in a row.
enum class Grid { kEven, kSheared };

/// `divergence` of zero in a direction gives one ray in it.
[[nodiscard]] SubRays subRaysOf(BeamProfile profile, AngularSize divergence, int horizontal, int vertical,
                                Grid grid = Grid::kEven);

}  // namespace model
