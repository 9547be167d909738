#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/desktop/cloud/camera.h"
#include "core/detections.h"

namespace desktop {

/// Where points come from. Everything that is shown twice has the measured side first. Silent are the beams from which
/// the simulated sensor reports nothing; they stand where their light was lost.
enum class CloudSource { Measured, Simulated, Silent };

/// What the colour of a point may tell.
enum class ColourBy { Source, Range, Intensity, EchoPulseWidth, Layer, Echo, Difference };

/// Detections and where they lie: p = range * (cos e cos a, cos e sin a, sin e). [m]
struct PointCloud {
  core::Detections detections;
  std::vector<float> x;
  std::vector<float> y;
  std::vector<float> z;
  /// The farthest points in a hundred directions, and the sensor: what frames them frames all, as good as the eye sees.
  std::vector<Point3> outline;

  [[nodiscard]] std::size_t size() const noexcept { return x.size(); }
  [[nodiscard]] int frames() const noexcept;  ///< 1 + the largest frame; 0 if there is nothing
};

/// Without recorded directions there are no places: the cloud has detections and no points.
[[nodiscard]] PointCloud pointCloudOf(core::Detections detections);

/// One number for each detection; empty if it was not recorded, for the source, and for what needs two clouds.
[[nodiscard]] std::vector<double> valuesFor(const PointCloud& cloud, ColourBy by);

/// What the detections of one beam and echo have in common, over all frames.
struct BeamSummary {
  std::size_t count = 0;
  double range_m = 0.0;                ///< mean
  std::optional<double> epw_m;         ///< mean; absent if not recorded
  std::optional<double> intensity_nw;  ///< mean; absent if not recorded
};

/// The detections in `cloud` of the beam that `picked` (a detection of `of`) belongs to, with the same echo number:
/// same layer, and the azimuth nearest to the picked one (around the circle), at most half a degree away. A beam
/// without echo (number 0) is compared with first echoes. Absent if there is none.
[[nodiscard]] std::optional<BeamSummary> sameBeam(const PointCloud& cloud, const PointCloud& of, std::size_t picked);

/// For each detection of `own`: the mean range that `other` has for the same beam and echo, minus its own range. [m]
/// NaN where `other` has none.
[[nodiscard]] std::vector<double> rangeDifferences(const PointCloud& own, const PointCloud& other);

}  // namespace desktop
