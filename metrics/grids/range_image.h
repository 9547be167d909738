#pragma once

#include <cstddef>
#include <vector>

#include "metrics/grids/cell_mask.h"
#include "metrics/series/series_pair.h"

namespace metrics {

/// Ranges as the sensor sees them, one pixel a beam.
///
///              azimuth ->
///   layer 0    21.3  21.3   nan      nan: the beam came back without an echo, a legal value here
///   layer 1     4.1   4.0  20.9
///
/// Frame: row and column mean the same beam in both images of a comparison; the image does not wrap around at 360°.
struct RangeImage {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<double> range_m;  ///< > 0 or NaN, row by row
};

/// What is compared. Referred to, not owned.
struct RangeImagePair {
  const RangeImage& simulated;
  const RangeImage& measured;
};

/// Throws InputError unless both images have the same rows and columns, and every range is positive or NaN; it names
/// the pixel. A range of 0 or infinity is refused because some sensors write it for "no echo": that is NaN here.
void requireComparable(const RangeImagePair& images);

/// The mask of the pixels with an echo.
[[nodiscard]] CellMask echoes(const RangeImage& image);

/// Ranges of the pixels that have an echo in both images, as two series for metrics/series/. They are blind to pixels
/// with an echo on one side only; read them together with ExistenceShares.
struct SharedPixels {
  explicit SharedPixels(const RangeImagePair& images);  ///< throws as requireComparable

  std::vector<double> simulated_m;
  std::vector<double> measured_m;

  [[nodiscard]] bool empty() const noexcept { return measured_m.empty(); }
  [[nodiscard]] SeriesPair pair() const noexcept { return {.simulated = simulated_m, .measured = measured_m}; }
};

/// Pixels on which the images disagree whether there is an echo. Both are shares of all pixels, in [0, 1].
struct ExistenceShares {
  double measured_only;   ///< echo in the measurement, none in the simulation
  double simulated_only;  ///< echo in the simulation, none in the measurement
};

[[nodiscard]] ExistenceShares existenceShares(const RangeImagePair& images);

/// Picture distance of the pixels with an echo (picture_distance.h), infinite if one image has none. [pixels]
[[nodiscard]] double echoPictureDistance(const RangeImagePair& images);

}  // namespace metrics
