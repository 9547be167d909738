#include "model/experiment.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>

#include "core/detection_files/detection_file.h"
#include "core/error.h"
#include "core/text.h"
#include "model/scene/mesh.h"
#include "model/sensor/layers.h"

namespace model {

using nlohmann::json;

namespace {

Measurand readMeasurand(core::JsonObject& object) {
  Measurand measurand;
  measurand.name = object.text("name");
  measurand.column = object.text("column");
  measurand.unit = object.textOr("unit", "");
  measurand.scale = object.choiceOr("scale", {"nominal", "ordinal", "interval", "ratio"}, "ratio");
  measurand.resolution = object.number("resolution", {.min = 0.0, .open_min = true});
  return measurand;
}

Environment readEnvironment(core::JsonObject object) {
  Environment environment;
  environment.temperature_degC = object.optionalNumber("temperature_degC", {.min = -273.15, .max = 200.0});
  environment.visibility_m = object.optionalNumber("visibility_m", {.min = 0.0, .open_min = true});
  environment.rain_rate_mm_h = object.optionalNumber("rain_rate_mm_h", {.min = 0.0});
  environment.background_irradiance_w_m2_nm = object.optionalNumber("background_irradiance_w_m2_nm", {.min = 0.0});
  object.finish();
  return environment;
}

Epistemic readEpistemic(core::JsonObject& object) {
  Epistemic epistemic;
  epistemic.path = object.text("path");
  const auto interval = object.numbers("offset_interval", 2);
  epistemic.low = interval[0];
  epistemic.high = interval[1];
  if (epistemic.low > epistemic.high) {
    object.fail("offset_interval", "has its ends in the wrong order.", "Write [low, high].");
  }
  return epistemic;
}

Role readRole(core::JsonObject& object) {
  const std::string role = object.choiceOr("role", {"calibration", "validation", "prediction"}, "validation");
  if (role == "calibration") return Role::kCalibration;
  return role == "prediction" ? Role::kPrediction : Role::kValidation;
}

/// A file of the package. Simulating and importing write there, so it must not leave the folder.
std::filesystem::path insidePackage(core::JsonObject& object, const std::string& key, const Experiment& experiment) {
  const std::filesystem::path given = object.text(key);
  const auto normal = given.lexically_normal();
  if (given.empty() || given.is_absolute() || *normal.begin() == ".." || !normal.has_filename() || normal == ".") {
    object.fail(key, "'" + given.string() + "' does not name a file inside the package.",
                "Copy the file into the folder of experiment.json and give its place relative to it.");
  }
  return experiment.folder() / given;
}

Sample readSample(core::JsonObject& object, const Experiment& experiment) {
  Sample sample;
  sample.id = object.text("id");
  sample.role = readRole(object);
  if (object.has("parameters")) {
    core::JsonObject parameters = object.object("parameters");
    for (const std::string& key : parameters.keys()) sample.parameters[key] = parameters.number(key);
  }
  sample.patch = object.has("patch") ? object.raw("patch") : json::array();
  object.eachObject("epistemic", [&](core::JsonObject& item) { sample.epistemic.push_back(readEpistemic(item)); });
  if (sample.epistemic.size() > 8) {
    object.fail("epistemic",
                fmt::format("has {} quantities; 2^{} corners would have to be simulated.", sample.epistemic.size(),
                            sample.epistemic.size()),
                "Keep at most 8 that matter.");
  }
  sample.frames = static_cast<int>(object.integer("frames", {.min = 1, .max = 10'000'000}));
  if (object.has("measurements")) sample.measurements = insidePackage(object, "measurements", experiment);
  sample.setup = object.textOr("setup", sample.id);
  if (object.has("beams")) sample.beams = insidePackage(object, "beams", experiment);
  if (!experiment.sensors.empty()) {
    sample.sensor = object.choice("sensor", experiment.sensors);
  } else {
    sample.sensor = object.textOr("sensor", "");
  }
  return sample;
}

/// Patches may add what an experiment can hold, and nothing else.
void refuseNewKeys(const Experiment& experiment, const Sample& sample, const json& patched) {
  static const std::vector<std::string> known{"format", "version", "id",         "title",       "source",
                                              "sensor", "sensors", "measurands", "environment", "materials",
                                              "scene",  "gates",   "samples",    "columns"};
  for (const auto& item : patched.items()) {
    const bool fine =
        std::find(known.begin(), known.end(), item.key()) != known.end() || item.key().rfind("x-", 0) == 0;
    if (fine) continue;
    const std::string nearest = core::nearestName(item.key(), known);
    throw core::InputError(
        {.file = experiment.file, .item = "sample '" + sample.id + "', patch"},
        "adds the unknown key '/" + item.key() + "'.",
        nearest.empty() ? "Known are " + core::join(known) + "." : "Did you mean '/" + nearest + "'?");
  }
}

void applyOffsets(json& value, const Experiment& experiment, const Sample& sample, const EpistemicOffsets& offsets) {
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    const std::string& path = sample.epistemic[i].path;
    const core::Place place{.file = experiment.file, .item = "sample '" + sample.id + "', epistemic " + path};
    try {
      json& target = value.at(json::json_pointer(path));
      if (!target.is_number())
        throw core::InputError(place, "does not point to a number.", "Point to the number itself.");
      target = target.get<double>() + offsets[i];
    } catch (const json::exception& error) {
      throw core::InputError(place, std::string("does not lead anywhere: ") + error.what() + ".",
                             "Check the JSON Pointer (RFC 6901).");
    }
  }
}

Situation readSituation(core::JsonObject& object) {
  Situation situation;
  situation.scene = readScene(object);
  if (object.has("environment")) situation.environment = readEnvironment(object.object("environment"));
  return situation;
}

void readSensors(core::JsonObject& object, Experiment& experiment) {
  if (object.has("sensors")) {
    core::JsonObject sensors = object.object("sensors");
    for (const std::string& name : sensors.keys()) {
      (void)resolveSensorProfile(sensors.raw(name), experiment.file, "/sensors/" + name);
      experiment.sensors.push_back(name);
    }
    if (object.has("sensor")) object.fail("sensor", "stands beside /sensors.", "Keep one of the two.");
  } else {
    (void)resolveSensorProfile(object.raw("sensor"), experiment.file, "/sensor");
  }
}

void readColumns(core::JsonObject columns, Experiment& experiment) {
  static const std::vector<std::string> known{"frame", "time_s",  "layer", "azimuth_rad", "elevation_rad",
                                              "echo",  "range_m", "epw_m", "intensity"};
  for (const std::string& name : known) {
    if (columns.has(name)) experiment.columns[name] = columns.text(name);
  }
  columns.finish();
}

void readGates(core::JsonObject& object, Experiment& experiment, const Scene& scene) {
  object.eachObject("gates", [&](core::JsonObject& item) {
    Gate gate{item.text("id"), item.text("object"), item.numberOr("margin_m", 0.0, {.min = 0.0})};
    const bool known = std::any_of(scene.objects.begin(), scene.objects.end(),
                                   [&](const SceneObject& o) { return o.id == gate.object; });
    if (!known) item.fail("object", "'" + gate.object + "' is not in the scene.", "Name the id of a scene object.");
    experiment.gates.push_back(gate);
  });
}

}  // namespace

std::string toString(Role role) {
  switch (role) {
    case Role::kCalibration:
      return "calibration";
    case Role::kValidation:
      return "validation";
    case Role::kPrediction:
      return "prediction";
  }
  return "";
}

const Measurand& Experiment::measurand(const std::string& name) const {
  std::vector<std::string> known;
  for (const Measurand& candidate : measurands) {
    if (candidate.name == name) return candidate;
    known.push_back(candidate.name);
  }
  const std::string nearest = core::nearestName(name, known);
  throw core::InputError({.file = file, .item = "/measurands"}, "has no measurand '" + name + "'.",
                         nearest.empty() ? "Known are " + core::join(known) + "." : "Did you mean '" + nearest + "'?");
}

std::size_t Experiment::sampleIndex(const std::string& sample_id) const {
  std::vector<std::string> known;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (samples[i].id == sample_id) return i;
    known.push_back(samples[i].id);
  }
  const std::string nearest = core::nearestName(sample_id, known);
  throw core::InputError({.file = file, .item = "/samples"}, "has no sample '" + sample_id + "'.",
                         nearest.empty() ? "Known are " + core::join(known) + "." : "Did you mean '" + nearest + "'?");
}

bool Experiment::synthetic() const { return core::lowerCase(source).find("synthetic") != std::string::npos; }

Experiment parseExperiment(json value, const std::filesystem::path& file) {
  Experiment experiment;
  experiment.file = file;
  experiment.json = std::move(value);
  core::JsonObject object(experiment.json, file);
  object.expectFormat("fidelis-experiment", 1);
  experiment.id = object.text("id");
  experiment.title = object.textOr("title", experiment.id);
  experiment.source = object.textOr("source", "");
  readSensors(object, experiment);
  object.eachObject("measurands",
                    [&](core::JsonObject& item) { experiment.measurands.push_back(readMeasurand(item)); });
  if (experiment.measurands.empty()) object.fail("measurands", "is missing or empty.", "Name at least one measurand.");
  if (object.has("columns")) readColumns(object.object("columns"), experiment);
  const Situation base = readSituation(object);
  readGates(object, experiment, base.scene);
  std::set<std::string> ids;
  object.eachObject("samples", [&](core::JsonObject& item) {
    experiment.samples.push_back(readSample(item, experiment));
    if (!ids.insert(experiment.samples.back().id).second) {
      item.fail("id", "'" + experiment.samples.back().id + "' stands twice.", "Give every sample its own id.");
    }
  });
  if (experiment.samples.empty()) object.fail("samples", "is missing or empty.", "Give at least one sample.");
  object.finish();
  for (const Sample& sample : experiment.samples) {
    (void)situationOf(experiment, sample, EpistemicOffsets(sample.epistemic.size(), 0.0));
  }
  return experiment;
}

Experiment readExperiment(const std::filesystem::path& path) {
  const auto file = std::filesystem::is_directory(path) ? path / "experiment.json" : path;
  return parseExperiment(core::readJson(file), file);
}

json recordedIn(const Experiment& experiment, const Sample& sample) {
  try {
    json value = experiment.json.patch(sample.patch);
    if (!sample.patch.empty()) refuseNewKeys(experiment, sample, value);
    return value;
  } catch (const json::exception& error) {
    throw core::InputError({.file = experiment.file, .item = "sample '" + sample.id + "', patch"},
                           std::string("cannot be applied: ") + error.what() + ".",
                           "Check op, path and value of each step (RFC 6902).");
  }
}

Situation situationOf(const Experiment& experiment, const Sample& sample, const EpistemicOffsets& offsets) {
  json value = recordedIn(experiment, sample);
  applyOffsets(value, experiment, sample, offsets);
  core::JsonObject object(value, experiment.file);
  return readSituation(object);
}

std::vector<EpistemicOffsets> epistemicCorners(const Sample& sample) {
  const std::size_t count = sample.epistemic.size();
  std::vector<EpistemicOffsets> corners{EpistemicOffsets(count, 0.0)};
  if (count == 0) return corners;
  for (std::size_t bits = 0; bits < (std::size_t{1} << count); ++bits) {
    EpistemicOffsets corner(count);
    for (std::size_t i = 0; i < count; ++i) {
      corner[i] = (bits >> i) & 1 ? sample.epistemic[i].high : sample.epistemic[i].low;
    }
    corners.push_back(corner);
  }
  return corners;
}

std::vector<Beam> beamsFired(const Experiment& experiment, const Sample& sample) {
  if (!sample.beams.empty()) return readBeams(sample.beams);
  const bool several = !experiment.sensors.empty();
  const std::string pointer = several ? "/sensors/" + sample.sensor : "/sensor";
  const json& sensor = several ? experiment.json.at("sensors").at(sample.sensor) : experiment.json.at("sensor");
  return beamsOf(resolveSensorProfile(sensor, experiment.file, pointer).scan);
}

core::Detections readMeasurements(const Experiment& experiment, const Sample& sample) {
  if (sample.measurements.empty()) {
    throw core::InputError({.file = experiment.file, .item = "sample '" + sample.id + "'"}, "names no measurements.",
                           "Add the key 'measurements'.");
  }
  core::Detections detections = core::readDetections(sample.measurements, experiment.columns);
  if (detections.layer.empty()) addLayers(detections, beamsFired(experiment, sample));
  return detections;
}

std::vector<std::size_t> indicesInsideGate(const core::Detections& detections, const Situation& situation,
                                           const Gate& gate) {
  const auto object = std::find_if(situation.scene.objects.begin(), situation.scene.objects.end(),
                                   [&](const SceneObject& o) { return o.id == gate.object; });
  if (object == situation.scene.objects.end() || !detections.hasDirections()) return {};
  const Bounds box = localBounds(object->shape);
  const auto within = [&](std::size_t i) {
    const double ce = std::cos(detections.elevation_rad[i]);
    const Vector3 local = object->pose.toLocal({detections.range_m[i] * ce * std::cos(detections.azimuth_rad[i]),
                                                detections.range_m[i] * ce * std::sin(detections.azimuth_rad[i]),
                                                detections.range_m[i] * std::sin(detections.elevation_rad[i])});
    for (std::size_t k = 0; k < 3; ++k) {
      if (local[k] < box.low[k] - gate.margin_m || local[k] > box.high[k] + gate.margin_m) return false;
    }
    return true;
  };
  std::vector<std::size_t> inside;
  for (std::size_t i = 0; i < detections.size(); ++i) {
    if (within(i)) inside.push_back(i);
  }
  return inside;
}

core::Detections insideGate(const core::Detections& detections, const Situation& situation, const Gate& gate) {
  return core::selected(detections, indicesInsideGate(detections, situation, gate));
}

namespace {

/// The measured pulse of a sensor that stands in the experiment itself; "" if there is none.
std::string pulseFileOf(const Experiment& experiment, const Sample& sample) {
  const auto sensor =
      sample.sensor.empty() ? json::json_pointer("/sensor") : json::json_pointer("/sensors") / sample.sensor;
  const auto file = sensor / "emitter" / "pulse_shape" / "file";
  return experiment.json.contains(file) ? experiment.json.at(file).get<std::string>() : "";
}

}  // namespace

std::vector<std::filesystem::path> filesOf(const Experiment& experiment, const Sample& sample) {
  std::vector<std::filesystem::path> files{experiment.file};
  if (!sample.measurements.empty()) files.push_back(sample.measurements);
  if (!sample.beams.empty()) files.push_back(sample.beams);
  const Situation situation = situationOf(experiment, sample);
  for (const SceneObject& object : situation.scene.objects) {
    if (const auto* mesh = std::get_if<Mesh>(&object.shape)) {
      const auto of_mesh = filesOfMesh(mesh->file);
      files.insert(files.end(), of_mesh.begin(), of_mesh.end());
    }
  }
  for (const Material& material : situation.scene.materials) {
    files.insert(files.end(), material.files.begin(), material.files.end());
  }
  const std::string pulse = pulseFileOf(experiment, sample);
  if (!pulse.empty()) files.push_back(experiment.folder() / pulse);
  return files;
}

}  // namespace model
