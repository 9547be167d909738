#include "bench/withheld/generator/package.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <thread>
#include <zlib.h>

#include "bench/withheld/generator/bad_input.h"

namespace withheld {

namespace fs = std::filesystem;

namespace {

Json::json_pointer pointerOf(const std::string& text, const std::string& place) {
  try {
    return Json::json_pointer(text);
  } catch (const Json::exception&) {
    throw BadInput(place, "'" + text + "' is no JSON Pointer.", "Begin it with a slash.");
  }
}

void shift(Json& experiment, const std::string& pointer, double by, const std::string& place) {
  const Json::json_pointer path = pointerOf(pointer, place);
  if (!experiment.contains(path) || !experiment[path].is_number()) {
    throw BadInput(place, "'" + pointer + "' is no number of the experiment.", "Point at a number.");
  }
  experiment[path] = experiment[path].get<double>() + by;
}

/// What truth.json adds to one set-up.
void applyTruth(const Json& truth, const std::string& file, const std::string& setup, std::uint64_t seed,
                Json& experiment) {
  if (truth.is_null()) return;
  const Fields fields(truth, file + ": ", {"reference_offsets", "setup_scatter"});
  if (const Json* offsets = fields.find("reference_offsets")) {
    for (const auto& [pointer, json] : offsets->items()) {
      const Fields offset(json, file + ": /reference_offsets", {"everywhere", "per_setup"});
      const Json* own = offset.find("per_setup");
      const double here = own && own->contains(setup) ? (*own)[setup].get<double>() : 0.0;
      shift(experiment, pointer, offset.number("everywhere", 0.0) + here, file);
    }
  }
  if (const Json* scatter = fields.find("setup_scatter")) {
    for (const auto& [pointer, spread] : scatter->items()) {
      Dice dice(seed, Use::setup, {nameOf(setup), nameOf(pointer)});
      shift(experiment, pointer, spread.get<double>() * dice.normal(), file);
    }
  }
}

Environment environmentOf(const Json& experiment, const std::string& place) {
  if (!experiment.contains("environment")) return {};
  const Fields fields(experiment["environment"], place + "/environment",
                      {"temperature_degC", "visibility_m", "rain_rate_mm_h", "background_irradiance_w_m2_nm"});
  return {fields.maybe("temperature_degC"), fields.maybe("visibility_m"), fields.maybe("rain_rate_mm_h"),
          fields.maybe("background_irradiance_w_m2_nm")};
}

std::vector<Beam> readBeams(const std::string& file) {
  std::ifstream stream(file);
  if (!stream) throw BadInput(file, "cannot be read.", "Add the list of beams.");
  std::vector<Beam> beams;
  std::map<int, int> in_layer;
  std::string line;
  std::getline(stream, line);
  if (!line.starts_with("layer,azimuth_rad,elevation_rad")) {
    throw BadInput(file + ":1", "is another header.", "Write layer,azimuth_rad,elevation_rad[,time_s].");
  }
  for (int number = 2; std::getline(stream, line); ++number) {
    if (line.empty() || line == "\r") continue;
    Beam beam;
    char comma = 0;
    std::istringstream cells(line);
    if (!(cells >> beam.layer >> comma >> beam.azimuth_rad >> comma >> beam.elevation_rad) || beam.layer < 0) {
      throw BadInput(fmt::format("{}:{}", file, number), "is no beam.", "Give layer, azimuth and elevation in rad.");
    }
    if (cells >> comma) cells >> beam.time_s;
    beam.column = in_layer[beam.layer]++;
    beams.push_back(beam);
  }
  return beams;
}

std::string insideOnly(const std::string& path, const std::string& place) {
  const fs::path normal = fs::path(path).lexically_normal();
  if (path.empty() || normal.is_absolute() || *normal.begin() == "..") {
    throw BadInput(place, "'" + path + "' lies outside the package.", "Give a path below its folder.");
  }
  return normal.string();
}

Sample readSample(const Fields& sample, const Json& base, const Json& truth, const std::string& truth_file,
                  std::uint64_t seed, const std::string& file, Package& package) {
  Sample result;
  result.id = sample.text("id");
  result.measurements = insideOnly(sample.text("measurements"), sample.placeOf("measurements"));
  result.frames = static_cast<int>(sample.number("frames"));
  if (sample.find("sensor")) result.sensor = sample.text("sensor");
  Json experiment = base;
  try {
    if (const Json* patch = sample.find("patch")) experiment = base.patch(*patch);
  } catch (const Json::exception& error) {
    throw BadInput(sample.placeOf("patch"), error.what(), "Repair the patch (RFC 6902).");
  }
  applyTruth(truth, truth_file, sample.find("setup") ? sample.text("setup") : result.id, seed, experiment);
  result.scene = readScene(experiment, file + ": ");
  result.environment = environmentOf(experiment, file + ": ");
  if (sample.find("beams")) {
    package.copied.push_back(insideOnly(sample.text("beams"), sample.placeOf("beams")));
    result.beams = readBeams((fs::path(package.folder) / package.copied.back()).string());
  }
  return result;
}

std::string inSteps(double value, double step) {
  const int decimals = step > 0.0 ? std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)) + 2, 0, 9) : 6;
  return fmt::format("{:.{}f}", value, decimals);
}

void writeFile(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  bool good = false;
  if (file.extension() == ".gz") {
    if (gzFile stream = gzopen(file.c_str(), "wb6")) {
      good = gzwrite(stream, text.data(), static_cast<unsigned>(text.size())) == static_cast<int>(text.size());
      good = gzclose(stream) == Z_OK && good;
    }
  } else {
    std::ofstream stream(file, std::ios::binary);
    stream << text;
    good = static_cast<bool>(stream.flush());
  }
  if (!good) throw BadInput(file.string(), "cannot be written.", "Check the folder's permissions and the space left.");
}

}  // namespace

Package readPackage(const std::string& folder, const std::string& truth_file, std::uint64_t seed) {
  Package package{folder, {}, {"experiment.json"}, {}};
  const std::string file = (fs::path(folder) / "experiment.json").string(), place = file + ": ";
  const Json experiment = readJson(file), truth = truth_file.empty() ? Json() : readJson(truth_file);
  const Fields fields(experiment, place,
                      {"format", "version", "id", "title", "source", "sensor", "sensors", "measurands", "environment",
                       "materials", "scene", "gates", "columns", "samples"});
  if (fields.text("format") != "fidelis-experiment") {
    throw BadInput(fields.placeOf("format"), "is not fidelis-experiment.", "Give an experiment package.");
  }
  if (const Json* columns = fields.find("columns")) package.names = columns->get<std::map<std::string, std::string>>();
  for (std::size_t i = 0; i < fields.at("samples").size(); ++i) {
    const Fields sample(
        experiment["samples"][i], fields.placeOf("samples") + "/" + std::to_string(i),
        {"id", "role", "parameters", "patch", "epistemic", "frames", "measurements", "setup", "beams", "sensor"});
    package.samples.push_back(readSample(sample, experiment, truth, truth_file, seed, file, package));
  }
  return package;
}

std::string measurementText(const std::vector<Detection>& detections, const std::vector<Beam>& beams,
                            const Profile& profile, const std::map<std::string, std::string>& names) {
  std::vector<std::string> columns{"frame", "time_s", "layer", "azimuth_rad", "elevation_rad", "echo", "range_m"};
  if (profile.has_epw) columns.push_back("epw_m");
  if (profile.has_intensity) columns.push_back("intensity");
  std::string text;
  for (const std::string& column : columns) {
    const auto own = names.find(column);
    text += (text.empty() ? "" : ",") + (own == names.end() ? column : own->second);
  }
  text += '\n';
  for (const Detection& d : detections) {
    const Beam& beam = beams[d.beam];
    text += fmt::format("{},{:.6f},{},{:.6f},{:.6f},{},{}", d.frame, beam.time_s, beam.layer, beam.azimuth_rad,
                        beam.elevation_rad, d.echo, inSteps(d.range_m, profile.range_step_m));
    if (profile.has_epw) text += ',' + inSteps(d.epw_m, profile.epw_step_m);
    if (profile.has_intensity) text += ',' + inSteps(d.intensity_nw, profile.intensity_step_nw);
    text += '\n';
  }
  return text;
}

void writePackage(const Package& package, const std::vector<std::string>& texts, const std::string& folder) {
  std::error_code ignored;
  if (fs::equivalent(package.folder, folder, ignored)) {
    throw BadInput(folder, "is the experiment itself.", "Name another folder with --out.");
  }
  for (const std::string& file : package.copied) {
    const fs::path to = fs::path(folder) / file;
    fs::create_directories(to.parent_path());
    fs::copy_file(fs::path(package.folder) / file, to, fs::copy_options::overwrite_existing);
  }
  for (std::size_t i = 0; i < texts.size(); ++i)
    writeFile(fs::path(folder) / package.samples[i].measurements, texts[i]);
}

namespace {

std::string simulateOne(const Sample& sample, const World& world, std::uint64_t seed,
                        const std::map<std::string, std::string>& names) {
  const auto sensor = world.sensors.find(sample.sensor);
  if (sensor == world.sensors.end()) {
    throw BadInput("sample '" + sample.id + "'",
                   "names the sensor '" + sample.sensor + "', which the model does not have.",
                   "Give the model the same sensors as the experiment.");
  }
  const Effects effects = world.effects.of(sample.sensor);
  Profile profile = sensor->second;
  profile.divergence_h_rad = effects.number("beam-divergence", "horizontal_rad", profile.divergence_h_rad);
  profile.divergence_v_rad = effects.number("beam-divergence", "vertical_rad", profile.divergence_v_rad);
  const std::vector<Beam> beams = sample.beams.empty() ? profile.scan : sample.beams;
  const Situation situation{profile,
                            effects,
                            sample.environment,
                            sample.scene,
                            beams,
                            sample.frames,
                            {profile.fwhm_ns, world.pulse_rise_share},
                            seed,
                            nameOf(sample.id)};
  return measurementText(fireAll(situation), beams, profile, names);
}

}  // namespace

std::vector<std::string> simulate(const Package& package, const World& world, std::uint64_t seed, int threads) {
  std::vector<std::string> texts(package.samples.size());
  std::vector<std::exception_ptr> errors(package.samples.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < texts.size(); i = next++) {
      try {
        texts[i] = simulateOne(package.samples[i], world, seed, package.names);
      } catch (...) {
        errors[i] = std::current_exception();
      }
    }
  };
  std::vector<std::thread> others;
  for (int i = 1; i < threads; ++i) others.emplace_back(work);
  work();
  for (std::thread& other : others) other.join();
  for (const std::exception_ptr& error : errors) {
    if (error) std::rethrow_exception(error);
  }
  return texts;
}

}  // namespace withheld
