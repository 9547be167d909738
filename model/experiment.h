#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/detections.h"
#include "model/scene/scene.h"
#include "model/sensor/beams.h"
#include "model/sensor/sensor_profile.h"

namespace model {

/// A quantity that the sensor reports and that is compared.
struct Measurand {
  std::string name;    ///< "range"
  std::string column;  ///< of the measurement CSV, "range_m"
  std::string unit;
  std::string scale;        ///< ratio, interval, ordinal, nominal
  double resolution = 0.0;  ///< one step of the sensor's output, > 0
};

/// What was recorded about the surroundings; absent means that nobody recorded it, not zero.
struct Environment {
  std::optional<double> temperature_degC;
  std::optional<double> visibility_m;
  std::optional<double> rain_rate_mm_h;
  std::optional<double> background_irradiance_w_m2_nm;
};

/// A region around an object that selects detections.
struct Gate {
  std::string id;
  std::string object;
  double margin_m = 0.0;
};

enum class Role { kCalibration, kValidation, kPrediction };
[[nodiscard]] std::string toString(Role role);

/// A quantity of the experiment that is known only to within an interval.
struct Epistemic {
  std::string path;  ///< JSON Pointer into the (patched) experiment
  double low = 0.0;  ///< offsets to the nominal value
  double high = 0.0;
};

/// One setting of the experiment with its measurement.
struct Sample {
  std::string id;
  Role role = Role::kValidation;
  std::map<std::string, double> parameters;  ///< coordinates in the parameter space
  nlohmann::json patch;                      ///< RFC 6902
  std::vector<Epistemic> epistemic;
  int frames = 1;
  std::filesystem::path measurements;  ///< absolute or relative to the working folder
  std::string setup;                   ///< samples of one set-up share one reference error; default: the sample's id
  std::string sensor;                  ///< which of several sensors; "" if there is one
  std::filesystem::path beams;         ///< own beam directions; "" if the profile's scan is fired
};

/// An experiment package (formats.md section 1).
struct Experiment {
  std::filesystem::path file;  ///< experiment.json
  nlohmann::json json;         ///< as read; patches apply to it
  std::string id;
  std::string title;
  std::string source;
  std::vector<Measurand> measurands;
  std::vector<std::string> sensors;  ///< names of several sensors; empty if there is one
  std::vector<Gate> gates;
  std::vector<Sample> samples;
  std::map<std::string, std::string> columns;  ///< our column names -> the files'

  [[nodiscard]] std::filesystem::path folder() const { return file.parent_path(); }
  /// Throws InputError with the nearest id.
  [[nodiscard]] const Measurand& measurand(const std::string& name) const;
  [[nodiscard]] std::size_t sampleIndex(const std::string& sample_id) const;
  /// "synthetic" stands in the source: no real sensor measured this.
  [[nodiscard]] bool synthetic() const;
};

/// What a sample looked like: scene and environment after its patch.
struct Situation {
  Scene scene;
  Environment environment;
};

/// Offsets to the epistemic quantities of a sample, in their order.
using EpistemicOffsets = std::vector<double>;

/// Reads `experiment.json` (or the folder that holds it) and checks everything in it, each sample's patch included.
/// Throws InputError with file, JSON Pointer and remedy.
[[nodiscard]] Experiment readExperiment(const std::filesystem::path& path);

/// The same for a changed JSON value of a package that lies at `file`.
[[nodiscard]] Experiment parseExperiment(nlohmann::json json, const std::filesystem::path& file);

/// The experiment's JSON with the sample's patch applied.
[[nodiscard]] nlohmann::json recordedIn(const Experiment& experiment, const Sample& sample);

/// Scene and environment of one sample, with epistemic offsets applied if any are given.
[[nodiscard]] Situation situationOf(const Experiment& experiment, const Sample& sample,
                                    const EpistemicOffsets& offsets = {});

/// The centre (all zero) first, then every corner of the epistemic box. 1 entry without epistemic quantities.
[[nodiscard]] std::vector<EpistemicOffsets> epistemicCorners(const Sample& sample);

/// The beams of the sensor that measured: the sample's own list, or the scan of the experiment's profile.
[[nodiscard]] std::vector<Beam> beamsFired(const Experiment& experiment, const Sample& sample);

/// The measured detections of a sample, from a file of any format (core/detection_files). Directions without layers get
/// those of the beams fired.
[[nodiscard]] core::Detections readMeasurements(const Experiment& experiment, const Sample& sample);

/// Detections inside the object's box, widened by the margin on all sides. The box is the nominal one.
[[nodiscard]] core::Detections insideGate(const core::Detections& detections, const Situation& situation,
                                          const Gate& gate);
/// The same as indices, in their order; none if directions were not recorded.
[[nodiscard]] std::vector<std::size_t> indicesInsideGate(const core::Detections& detections, const Situation& situation,
                                                         const Gate& gate);

/// The files that a sample's evaluation depends on: experiment.json, measurements, beams, meshes and
/// tables of materials and measured pulse.
[[nodiscard]] std::vector<std::filesystem::path> filesOf(const Experiment& experiment, const Sample& sample);

}  // namespace model
