#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/json_object.h"
#include "model/sensor/scan.h"
#include "model/signal/pulse_shape.h"

namespace model {

enum class BeamProfile { kUniform, kGaussian };
enum class RangeMode { kPeak, kLeadingEdge, kCentre };

/// Two full angular widths: edge to edge of a uniform beam, 1/e² of a Gaussian one.
struct AngularSize {
  double horizontal_rad = 0.0;
  double vertical_rad = 0.0;
};

struct Emitter {
  double wavelength_nm = 905.0;
  double peak_power_w = 0.0;
  double pulse_fwhm_ns = 0.0;
  PulseShape pulse_shape;  ///< Gaussian unless it was measured
  AngularSize divergence;
  BeamProfile beam_profile = BeamProfile::kUniform;
};

struct Receiver {
  double aperture_diameter_m = 0.0;
  double efficiency = 1.0;
  double axis_offset_m = 0.0;
  AngularSize field_of_view;
  double noise_w = 0.0;      ///< standard deviation of the input-referred noise
  double threshold_w = 0.0;  ///< on the received power
  std::optional<double> saturation_w;
  std::optional<double> knee_sharpness;  ///< how it bends there (saturation_knee.h); no profile has one
};

struct DetectionStage {
  int max_echoes = 1;
  double echo_separation_m = 0.0;
  RangeMode range_mode = RangeMode::kPeak;
  double min_range_m = 0.0;
  double max_range_m = 0.0;
  double range_resolution_m = 0.0;  ///< 0: not rounded
  double epw_resolution_m = 0.0;
  double intensity_resolution_nw = 0.0;
  double range_noise_m = 0.0;
  double epw_noise_m = 0.0;
  std::vector<std::string> output;  ///< of range, epw, intensity
};

/// What a lidar is, as data (formats.md section 2). Frame: ISO 8855, sensor at the origin, looking along +x.
struct SensorProfile {
  std::string id;
  std::string title;
  std::string source;
  Emitter emitter;
  Receiver receiver;
  Scan scan;
  DetectionStage detection;
};

/// Reads a profile object. Throws InputError with JSON Pointer for what is missing, unknown or out of range.
[[nodiscard]] SensorProfile readSensorProfile(core::JsonObject& object);

/// A profile in place (`value` is an object) or by id (`value` is a text): resources/sensors/<id>.json.
/// `place` names file and pointer of the value.
[[nodiscard]] SensorProfile resolveSensorProfile(const nlohmann::json& value, const std::filesystem::path& file,
                                                 const std::string& pointer);

/// The profile's JSON object itself: what stands in the value, or in the file that it names.
[[nodiscard]] nlohmann::json sensorProfileJson(const nlohmann::json& value, const std::filesystem::path& file,
                                               const std::string& pointer);

/// Puts the profiles themselves in place of their ids: in `sensor` or `sensors` of a model file or an experiment.
void writeOutSensors(nlohmann::json& document, const std::filesystem::path& file);

}  // namespace model
