#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/withheld/generator/fields.h"

namespace withheld {

/// A beam as the sensor reports it. `gain` is the share of the emitter's power that it gets.
struct Beam {
  int layer = 0;
  int column = 0;  ///< place in the order of azimuths, 0 is fired first
  double azimuth_rad = 0.0;
  double elevation_rad = 0.0;
  double time_s = 0.0;  ///< after the start of the frame
  double gain = 1.0;
};

enum class RangeMode { peak, leading_edge, centre };

/// A lidar as its profile states it. Own reading of the format; Lissajous scans and measured pulses are refused.
struct Profile {
  double wavelength_nm = 905.0, peak_power_w = 0.0, fwhm_ns = 0.0;
  double divergence_h_rad = 0.0, divergence_v_rad = 0.0;
  bool gaussian_beam = false;
  double aperture_m = 0.0, efficiency = 1.0, axis_offset_m = 0.0, fov_h_rad = 0.01, fov_v_rad = 0.01;
  double noise_w = 0.0, threshold_w = 0.0;
  std::optional<double> saturation_w;
  int max_echoes = 1;
  double separation_m = 0.0;
  RangeMode mode = RangeMode::peak;
  double min_range_m = 0.0, max_range_m = 0.0;
  double range_step_m = 0.0, epw_step_m = 0.0, intensity_step_nw = 0.0, range_noise_m = 0.0, epw_noise_m = 0.0;
  bool has_epw = false, has_intensity = false;
  std::vector<Beam> scan;  ///< one frame, in order of firing
};

/// Throws BadInput.
[[nodiscard]] Profile readProfile(const Json& json, const std::string& place);

}  // namespace withheld
