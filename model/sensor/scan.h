#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/json_object.h"
#include "model/sensor/azimuth_gain.h"

namespace model {

/// One row of the scan: columns from `azimuth_from_deg` on, both ends included. Azimuth a is in degrees.
struct Layer {
  double elevation_deg = 0.0;
  double azimuth_from_deg = 0.0;
  double azimuth_to_deg = 0.0;
  double azimuth_step_deg = 1.0;
  std::vector<double> elevation_curve_deg;  ///< c0, c1, …: the row lies at elevation_deg + c0 + c1 a + c2 a² + …
  double time_offset_s = 0.0;               ///< its beams are fired so much later
  AzimuthGain gain;

  [[nodiscard]] double elevationAt_deg(double azimuth_deg) const;
};

/// A mirror that swings on two axes with one frequency while the height of its swing grows (MEMS, up-ramp):
///
///   azimuth   = A · cos(2π F t)              0 <= t < periods / F, periods = floor(F · ramp)
///   elevation = E · t / ramp · sin(2π F t)
///
/// Beams are fired wherever the azimuth passes A, A - step, … -A on the way right and the points between on the way
/// back. Each way is a layer of its own: within a layer, azimuth alone tells beams apart.
struct Lissajous {
  double azimuth_amplitude_deg = 0.0;    ///< A
  double elevation_amplitude_deg = 0.0;  ///< E, what is reached at the end of the ramp
  double azimuth_step_deg = 1.0;
  double mirror_frequency_hz = 0.0;  ///< F
  double ramp_s = 0.0;
  AzimuthGain gain;

  [[nodiscard]] int periods() const;
};

/// Where and when the beams of a frame are fired: by layers, or along a Lissajous figure.
struct Scan {
  double frame_rate_hz = 10.0;
  double duty = 1.0;          ///< part of the frame period in which beams are fired; not of a Lissajous figure
  bool left_to_right = true;  ///< falling azimuth; not of a Lissajous figure
  std::vector<Layer> layers;  ///< empty if and only if `lissajous` is there
  std::optional<Lissajous> lissajous;
  bool at_once = false;  ///< flash: all beams of a layer at its time offset
};

/// More beams a frame than this are refused when a profile is read.
inline constexpr double kMostBeams = 2e7;

/// Beams of one frame, counted without making them. (As a number that cannot overflow.)
[[nodiscard]] double beamCount(const Scan& scan);

/// Rows by which detections are numbered: layers, or ways of the mirror.
[[nodiscard]] std::size_t layerCount(const Scan& scan);

/// Share of the peak power of a beam at that place. A layer that the scan does not have has gain 1.
[[nodiscard]] double gainOf(const Scan& scan, std::int32_t layer, double azimuth_rad);

/// Throws InputError with JSON Pointer for what is missing, unknown or out of range, and for more than kMostBeams
/// beams with the memory that they would take.
[[nodiscard]] Scan readScan(core::JsonObject object);

}  // namespace model
