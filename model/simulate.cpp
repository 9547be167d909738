#include "model/simulate.h"

#include <set>
#include <system_error>

#include "core/detection_files/detection_file.h"
#include "core/error.h"
#include "core/file.h"
#include "core/new_folder.h"
#include "core/version.h"
#include "model/external/external_runs.h"
#include "model/package_files.h"

namespace model {

namespace fs = std::filesystem;

namespace {

constexpr const char* kReflectionFolder = "reflections";
constexpr const char* kTraceEnding = ".osi";

SignalChain chainOf(const LidarModel& model, const Sample& sample, const Environment& environment) {
  return {model.sensor(sample.sensor), model.effectsOf(sample.sensor), environment};
}

nlohmann::json simulatedExperimentJson(const Experiment& experiment, const LidarModel& model,
                                       const PackageReflections& reflections) {
  nlohmann::json json = experiment.json;
  json["source"] = "synthetic: simulated by fidelis " + std::string(core::kVersion) + " with the model '" + model.id +
                   "' after the experiment '" + experiment.id + "'";
  if (!reflections.from.empty()) {
    json["source"] = json["source"].get<std::string>() + ", from the reflections of " + reflections.from.string();
  }
  json.erase("columns");  // the simulated files have our own column names
  std::set<fs::path> written{"experiment.json"};
  const auto claim = [&](const std::string& key, std::size_t sample) {
    const std::string file = json["samples"][sample][key];
    if (written.insert(fs::path(file).lexically_normal()).second) return;
    throw core::InputError({.file = experiment.file, .item = "/samples/" + std::to_string(sample) + "/" + key},
                           "'" + file + "' would be written twice.", "Give every sample a file of its own.");
  };
  for (std::size_t i = 0; i < experiment.samples.size(); ++i) {
    if (experiment.samples[i].measurements.empty()) {
      json["samples"][i]["measurements"] = "measurements/" + fileNameOf(experiment.samples[i].id) + ".csv";
    }
    claim("measurements", i);
    if (!reflections.write) continue;
    json["samples"][i]["x-reflections"] =
        (fs::path(kReflectionFolder) / (fileNameOf(experiment.samples[i].id) + kTraceEnding)).generic_string();
    claim("x-reflections", i);
  }
  return json;
}

/// Where a sample's reflections lie in what was named as their source.
fs::path reflectionFile(const Experiment& experiment, const Sample& sample, const fs::path& from) {
  const std::string name = fileNameOf(sample.id) + kTraceEnding;
  if (fs::is_directory(from)) {
    return fs::is_directory(from / kReflectionFolder) ? from / kReflectionFolder / name : from / name;
  }
  if (experiment.samples.size() > 1) {
    throw core::InputError({.file = from},
                           "is one trace of reflections, but the experiment has " +
                               std::to_string(experiment.samples.size()) + " samples.",
                           "Give a folder with a trace for each sample, here " + name + ".");
  }
  return from;
}

/// One view for all frames of the sample, or one for each.
void checkMessages(const ReflectionTrace& trace, const Sample& sample) {
  if (trace.views.size() == 1 || trace.views.size() == static_cast<std::size_t>(sample.frames)) return;
  throw core::InputError({.file = trace.file},
                         "has " + std::to_string(trace.views.size()) + " messages, but the sample '" + sample.id +
                             "' has " + std::to_string(sample.frames) + " frames.",
                         "Write one message for every frame, or one that holds for all of them.");
}

std::vector<Shot> receiveView(const ReflectionTrace& trace, std::size_t message, const SignalChain& chain,
                              const Fired& fired, const Scene& scene, const RunOptions& options) {
  const BeamHits hits = hitsOf(trace.views[message], fired, chain.settings(), trace.placeOf(message));
  return chain.run(hits, scene, options);
}

/// A message for each of the frames, or the one message for all of them.
std::vector<Shot> receiveViews(const ReflectionTrace& trace, const SignalChain& chain, const Fired& fired,
                               const Scene& scene, const RunOptions& options) {
  if (trace.views.size() == 1) return receiveView(trace, 0, chain, fired, scene, options);
  std::vector<Shot> shots;
  for (std::size_t m = 0; m < trace.views.size(); ++m) {
    RunOptions of_frame = options;
    of_frame.first_frame = static_cast<int>(m);
    of_frame.frames = 1;
    const std::vector<Shot> more = receiveView(trace, m, chain, fired, scene, of_frame);
    shots.insert(shots.end(), more.begin(), more.end());
  }
  return shots;
}

core::InputError noReflections(const LidarModel& model) {
  return {{.file = model.file},
          "is not the built-in lidar: it has no reflections on the way to its detections.",
          "Name a model file with 'sensor' and 'effects'."};
}

Fired aimed(const SignalChain& chain, const LidarModel& model, std::vector<Beam> beams) {
  chain.aim(beams);
  return {std::move(beams), chain.subRays(model.rays_horizontal, model.rays_vertical)};
}

}  // namespace

std::vector<Beam> beamsOfSample(const Experiment& experiment, const LidarModel& model, const Sample& sample) {
  if (model.external) return beamsFired(experiment, sample);
  const Scan& scan = model.sensor(sample.sensor).scan;
  if (sample.beams.empty()) return beamsOf(scan);
  std::vector<Beam> beams = readBeams(sample.beams);
  applyGain(scan, beams);
  return beams;
}

TracedSample traceSample(const Experiment& experiment, const LidarModel& model, const Sample& sample,
                         const EpistemicOffsets& offsets) {
  TracedSample traced;
  traced.situation = situationOf(experiment, sample, offsets);
  const SignalChain chain = chainOf(model, sample, traced.situation.environment);
  std::vector<Beam> beams = beamsOfSample(experiment, model, sample);
  chain.aim(beams);
  traced.hits = traceWith(chain, traced.situation.scene, std::move(beams),
                          chain.subRays(model.rays_horizontal, model.rays_vertical));
  return traced;
}

RayTracer tracerOf(const Scene& scene, const ChainSettings& settings, std::span<const Beam> beams) {
  const Vector3& own = settings.sensor_velocity_m_s;
  if (own == Vector3{}) return RayTracer(scene, timesOf(beams));
  Scene relative = scene;
  for (SceneObject& object : relative.objects) {
    for (std::size_t k = 0; k < 3; ++k) object.velocity_m_s[k] -= own[k];
  }
  return RayTracer(relative, timesOf(beams));
}

BeamHits traceWith(const SignalChain& chain, const Scene& scene, std::vector<Beam> beams, const SubRays& rays) {
  const RayTracer tracer = tracerOf(scene, chain.settings(), beams);
  return traceBeams(tracer, std::move(beams), rays, chain.settings().sensor_position_m, chain.secondWays(scene));
}

core::Detections simulate(const Experiment& experiment, const LidarModel& model, std::size_t sample_index,
                          const EpistemicOffsets& offsets, std::optional<std::uint64_t> seed) {
  if (model.external) return externalRun(experiment, model, {sample_index, offsets}, seed).detections;
  const Sample& sample = experiment.samples.at(sample_index);
  const RunOptions options{
      .seed = seed.value_or(model.seed), .sample = static_cast<std::uint32_t>(sample_index), .frames = sample.frames};
  const Situation situation = situationOf(experiment, sample, offsets);
  const SignalChain chain = chainOf(model, sample, situation.environment);
  const std::vector<Beam> nominal = beamsOfSample(experiment, model, sample);
  std::vector<Beam> beams = nominal;
  chain.aim(beams);
  const SubRays rays = chain.subRays(model.rays_horizontal, model.rays_vertical);
  std::vector<Shot> shots;
  if (chain.couplesBeams()) {
    shots = chain.run(traceWith(chain, situation.scene, std::move(beams), rays), situation.scene, options);
  } else {
    const RayTracer tracer = tracerOf(situation.scene, chain.settings(), beams);
    const GeometryPass pass(tracer, beams, rays, chain.settings().sensor_position_m, chain.secondWays(situation.scene));
    shots = chain.run(pass, situation.scene, options);
  }
  return toDetections(shots, nominal, model.sensor(sample.sensor));
}

core::LidarSensorView simulateReflections(const Experiment& experiment, const LidarModel& model, const Sample& sample) {
  const TracedSample traced = traceSample(experiment, model, sample);
  return reflectionsOf(traced.hits, chainOf(model, sample, traced.situation.environment), traced.situation.scene);
}

core::Detections receive(const ReflectionTrace& trace, const Experiment& experiment, const LidarModel& model,
                         std::size_t sample_index, std::optional<std::uint64_t> seed) {
  const Sample& sample = experiment.samples.at(sample_index);
  checkMessages(trace, sample);
  const RunOptions options{
      .seed = seed.value_or(model.seed), .sample = static_cast<std::uint32_t>(sample_index), .frames = sample.frames};
  const Situation situation = situationOf(experiment, sample);
  const SignalChain chain = chainOf(model, sample, situation.environment);
  const std::vector<Beam> nominal = beamsOfSample(experiment, model, sample);
  const Fired fired = aimed(chain, model, nominal);
  return toDetections(receiveViews(trace, chain, fired, situation.scene, options), nominal,
                      model.sensor(sample.sensor));
}

core::Detections receive(const ReflectionTrace& trace, const LidarModel& model, const std::string& sensor,
                         std::optional<std::uint64_t> seed) {
  if (model.external) throw noReflections(model);
  const SensorProfile& profile = model.sensor(sensor);
  const SignalChain chain(profile, model.effectsOf(sensor), {});
  const std::vector<Beam> nominal = beamsOf(profile.scan);
  const RunOptions options{.seed = seed.value_or(model.seed), .sample = 0, .frames = 1};
  return toDetections(receiveViews(trace, chain, aimed(chain, model, nominal), {}, options), nominal, profile);
}

void simulatePackage(const Experiment& experiment, const LidarModel& model, const fs::path& folder,
                     std::optional<std::uint64_t> seed, core::Progress& progress,
                     const std::function<void(const fs::path&)>& finish, const PackageReflections& reflections) {
  core::NewFolder package(folder);
  if (model.external && (reflections.write || !reflections.from.empty())) throw noReflections(model);
  const nlohmann::json json = simulatedExperimentJson(experiment, model, reflections);
  const std::vector<ExternalRun> external = nominalRuns(experiment, model, seed, progress);
  const auto detectionsOf = [&](std::size_t i) {
    if (model.external) return external[i].detections;
    if (reflections.from.empty()) return simulate(experiment, model, i, {}, seed);
    const fs::path file = reflectionFile(experiment, experiment.samples[i], reflections.from);
    return receive(readReflections(file), experiment, model, i, seed);
  };
  const auto placeFor = [&](std::size_t i, const char* key) {
    const fs::path file = package.path() / json["samples"][i][key].get<std::string>();
    fs::create_directories(file.parent_path());
    return file;
  };
  try {
    copyReferenced(experiment, package.path());
    for (std::size_t i = 0; i < experiment.samples.size(); ++i) {
      core::stopIfCancelled(progress);
      progress.report(static_cast<double>(i) / static_cast<double>(experiment.samples.size()),
                      "simulating " + experiment.samples[i].id);
      core::writeDetections(placeFor(i, "measurements"), detectionsOf(i));
      if (!reflections.write) continue;
      const core::LidarSensorView view = simulateReflections(experiment, model, experiment.samples[i]);
      core::writeLidarSensorViews(placeFor(i, "x-reflections"), std::span(&view, 1));
    }
    core::writeJson(package.path() / "experiment.json", json);
    if (finish) finish(package.path());
  } catch (const fs::filesystem_error& error) {
    throw core::InputError({.file = folder}, "cannot be written: " + error.code().message() + ".",
                           "Check that its parent folder exists and that you may write there.");
  }
  package.appear();
  progress.report(1.0, "done");
}

}  // namespace model
