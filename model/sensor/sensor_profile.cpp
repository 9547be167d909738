#include "model/sensor/sensor_profile.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/file.h"
#include "core/text.h"

namespace model {

namespace {

constexpr core::Bounds kPositive{.min = 0.0, .open_min = true};
constexpr core::Bounds kNotNegative{.min = 0.0};
constexpr core::Bounds kFraction{.min = 0.0, .max = 1.0};

AngularSize readAngularSize(core::JsonObject parent, const std::string& key) {
  core::JsonObject size = parent.object(key);
  AngularSize result{size.number("horizontal", kNotNegative), size.number("vertical", kNotNegative)};
  size.finish();
  return result;
}

/// A beam whose width is not known has no divergence_rad at all; a zero would make beam-divergence a lie.
AngularSize readDivergence(core::JsonObject& parent) {
  const AngularSize size = readAngularSize(parent, "divergence_rad");
  for (const auto& [name, width_rad] :
       {std::pair{"horizontal", size.horizontal_rad}, {"vertical", size.vertical_rad}}) {
    if (width_rad > 0.0) continue;
    parent.fail(std::string("divergence_rad/") + name, "is 0; every beam has a width.",
                "Give the full width in rad, or leave out divergence_rad if it is not known.");
  }
  return size;
}

/// `pulse_shape` brings its own width; a width beside it must be the same (it tells ns from ps).
void readPulse(core::JsonObject& object, Emitter& emitter) {
  constexpr double kAgreement = 0.05;
  const bool measured = object.has("pulse_shape");
  const auto given_ns = object.optionalNumber("pulse_fwhm_ns", kPositive);
  if (!measured) {
    emitter.pulse_fwhm_ns = object.number("pulse_fwhm_ns", kPositive);
    return;
  }
  core::JsonObject shape = object.object("pulse_shape");
  const auto file = shape.file().parent_path() / shape.text("file");
  emitter.pulse_shape = readPulseShape(file, shape.optionalNumber("step_ns", kPositive));
  shape.finish();
  emitter.pulse_fwhm_ns = emitter.pulse_shape.width();
  if (given_ns && std::abs(*given_ns / emitter.pulse_fwhm_ns - 1.0) > kAgreement) {
    object.fail("pulse_fwhm_ns",
                "is " + core::significant(*given_ns) + " ns, but the pulse in " + file.string() + " is " +
                    core::significant(emitter.pulse_fwhm_ns) + " ns wide.",
                "Leave pulse_fwhm_ns out: the measured pulse has its own width.");
  }
}

Emitter readEmitter(core::JsonObject object) {
  Emitter emitter;
  emitter.wavelength_nm = object.number("wavelength_nm", {.min = 200.0, .max = 20000.0});
  emitter.peak_power_w = object.number("peak_power_w", kPositive);
  readPulse(object, emitter);
  if (object.has("divergence_rad")) emitter.divergence = readDivergence(object);
  emitter.beam_profile = object.choiceOr("beam_profile", {"uniform", "gaussian"}, "uniform") == "gaussian"
                             ? BeamProfile::kGaussian
                             : BeamProfile::kUniform;
  object.finish();
  return emitter;
}

Receiver readReceiver(core::JsonObject object) {
  Receiver receiver;
  receiver.aperture_diameter_m = object.number("aperture_diameter_m", kPositive);
  receiver.efficiency = object.numberOr("efficiency", 1.0, kFraction);
  receiver.axis_offset_m = object.numberOr("axis_offset_m", 0.0);
  if (object.has("field_of_view_rad")) receiver.field_of_view = readAngularSize(object, "field_of_view_rad");
  receiver.noise_w = object.numberOr("noise_w", 0.0, kNotNegative);
  receiver.threshold_w = object.number("threshold_w", kPositive);
  receiver.saturation_w = object.optionalNumber("saturation_w", kPositive);
  object.finish();
  return receiver;
}

DetectionStage readDetectionStage(core::JsonObject object) {
  DetectionStage stage;
  stage.max_echoes = static_cast<int>(object.integerOr("max_echoes", 1, {.min = 1, .max = 100}));
  stage.echo_separation_m = object.numberOr("echo_separation_m", 0.0, kNotNegative);
  const std::string mode = object.choiceOr("range_mode", {"peak", "leading-edge", "centre"}, "peak");
  stage.range_mode = mode == "peak"     ? RangeMode::kPeak
                     : mode == "centre" ? RangeMode::kCentre
                                        : RangeMode::kLeadingEdge;
  stage.min_range_m = object.numberOr("min_range_m", 0.0, kNotNegative);
  stage.max_range_m = object.number("max_range_m", kPositive);
  stage.range_resolution_m = object.numberOr("range_resolution_m", 0.0, kNotNegative);
  stage.epw_resolution_m = object.numberOr("epw_resolution_m", 0.0, kNotNegative);
  stage.intensity_resolution_nw = object.numberOr("intensity_resolution", 0.0, kNotNegative);
  stage.range_noise_m = object.numberOr("range_noise_m", 0.0, kNotNegative);
  stage.epw_noise_m = object.numberOr("epw_noise_m", 0.0, kNotNegative);
  stage.output = object.texts("output");
  const std::vector<std::string> known{"range", "epw", "intensity"};
  for (std::size_t i = 0; i < stage.output.size(); ++i) {
    if (std::find(known.begin(), known.end(), stage.output[i]) != known.end()) continue;
    const std::string nearest = core::nearestName(stage.output[i], known);
    object.fail("output/" + std::to_string(i), "'" + stage.output[i] + "' is no output.",
                nearest.empty() ? "Known are " + core::join(known) + "." : "Did you mean '" + nearest + "'?");
  }
  if (stage.output.empty()) stage.output = {"range"};
  if (stage.min_range_m >= stage.max_range_m) {
    object.fail("min_range_m", "is not below max_range_m: the window is empty.", "Exchange or correct the two.");
  }
  object.finish();
  return stage;
}

}  // namespace

SensorProfile readSensorProfile(core::JsonObject& object) {
  object.expectFormat("fidelis-sensor", 1);
  SensorProfile profile;
  profile.id = object.text("id");
  profile.title = object.textOr("title", profile.id);
  profile.source = object.textOr("source", "");
  profile.emitter = readEmitter(object.object("emitter"));
  profile.receiver = readReceiver(object.object("receiver"));
  profile.scan = readScan(object.object("scan"));
  profile.detection = readDetectionStage(object.object("detection"));
  object.finish();
  return profile;
}

nlohmann::json sensorProfileJson(const nlohmann::json& value, const std::filesystem::path& file,
                                 const std::string& pointer) {
  if (!value.is_string()) return value;
  const auto folder = core::resourceFolder() / "sensors";
  const auto profile = folder / (value.get<std::string>() + ".json");
  if (std::filesystem::is_regular_file(profile)) return core::readJson(profile);
  std::vector<std::string> known;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    if (entry.path().extension() == ".json") known.push_back(entry.path().stem().string());
  }
  std::sort(known.begin(), known.end());
  const std::string nearest = core::nearestName(value.get<std::string>(), known);
  throw core::InputError({.file = file, .item = pointer},
                         "there is no sensor profile '" + value.get<std::string>() + "'.",
                         (nearest.empty() ? "" : "Did you mean '" + nearest + "'? ") +
                             ("Known are " + core::join(known) + "; or put the profile itself there."));
}

void writeOutSensors(nlohmann::json& document, const std::filesystem::path& file) {
  if (document.contains("sensor")) document["sensor"] = sensorProfileJson(document["sensor"], file, "/sensor");
  if (!document.contains("sensors")) return;
  for (auto& [name, sensor] : document["sensors"].items()) sensor = sensorProfileJson(sensor, file, "/sensors/" + name);
}

SensorProfile resolveSensorProfile(const nlohmann::json& value, const std::filesystem::path& file,
                                   const std::string& pointer) {
  const nlohmann::json profile = sensorProfileJson(value, file, pointer);
  const auto origin =
      value.is_string() ? core::resourceFolder() / "sensors" / (value.get<std::string>() + ".json") : file;
  core::JsonObject object(profile, origin, value.is_string() ? "" : pointer);
  return readSensorProfile(object);
}

}  // namespace model
