#include "model/simulate.h"

#include "core/error.h"
#include "core/file.h"
#include "core/version.h"

namespace model {

namespace {

SignalChain chainOf(const LidarModel& model, const Sample& sample, const Environment& environment) {
  return {model.sensor(sample.sensor), model.effects, environment};
}

SubRays subRays(const LidarModel& model, const ChainSettings& settings) {
  return subRaysOf(settings.emitter.beam_profile, settings.divergence, model.rays_horizontal, model.rays_vertical);
}

/// Copies what the package refers to besides the measurements, keeping relative places.
void copyReferenced(const Experiment& experiment, const std::filesystem::path& folder) {
  for (const Sample& sample : experiment.samples) {
    for (const std::filesystem::path& file : filesOf(experiment, sample)) {
      if (file == experiment.file || file == sample.measurements) continue;
      const auto target = folder / std::filesystem::relative(file, experiment.folder());
      std::filesystem::create_directories(target.parent_path());
      std::filesystem::copy_file(file, target, std::filesystem::copy_options::overwrite_existing);
    }
  }
}

nlohmann::json simulatedExperimentJson(const Experiment& experiment, const LidarModel& model) {
  nlohmann::json json = experiment.json;
  json["source"] = "synthetic: simulated by fidelis " + std::string(core::kVersion) + " with the model '" + model.id +
                   "' after the experiment '" + experiment.id + "'";
  json.erase("columns");  // the simulated files have our own column names
  for (std::size_t i = 0; i < experiment.samples.size(); ++i) {
    if (experiment.samples[i].measurements.empty()) {
      json["samples"][i]["measurements"] = "measurements/" + experiment.samples[i].id + ".csv";
    }
  }
  return json;
}

}  // namespace

std::vector<Beam> beamsOfSample(const Experiment&, const LidarModel& model, const Sample& sample) {
  return sample.beams.empty() ? beamsOf(model.sensor(sample.sensor).scan) : readBeams(sample.beams);
}

TracedSample traceSample(const Experiment& experiment, const LidarModel& model, const Sample& sample,
                         const EpistemicOffsets& offsets) {
  TracedSample traced;
  traced.situation = situationOf(experiment, sample, offsets);
  const SignalChain chain = chainOf(model, sample, traced.situation.environment);
  std::vector<Beam> beams = beamsOfSample(experiment, model, sample);
  chain.aim(beams);
  const RayTracer tracer(traced.situation.scene);
  traced.hits = traceBeams(tracer, std::move(beams), subRays(model, chain.settings()));
  return traced;
}

core::Detections simulate(const Experiment& experiment, const LidarModel& model, std::size_t sample_index,
                          const EpistemicOffsets& offsets, std::optional<std::uint64_t> seed) {
  const Sample& sample = experiment.samples.at(sample_index);
  const TracedSample traced = traceSample(experiment, model, sample, offsets);
  const SignalChain chain = chainOf(model, sample, traced.situation.environment);
  const auto shots = chain.run(traced.hits, traced.situation.scene,
                               {.seed = seed.value_or(model.seed),
                                .sample = static_cast<std::uint32_t>(sample_index),
                                .frames = sample.frames});
  return toDetections(shots, beamsOfSample(experiment, model, sample), model.sensor(sample.sensor));
}

void simulatePackage(const Experiment& experiment, const LidarModel& model, const std::filesystem::path& folder,
                     std::optional<std::uint64_t> seed, core::Progress& progress) {
  namespace fs = std::filesystem;
  if (fs::exists(folder) && (!fs::is_directory(folder) || !fs::is_empty(folder))) {
    throw core::InputError({.file = folder}, "exists and is not an empty folder.", "Name a new folder for the result.");
  }
  const fs::path part = folder.string() + ".part";
  fs::remove_all(part);
  try {
    fs::create_directories(part);
    const nlohmann::json json = simulatedExperimentJson(experiment, model);
    copyReferenced(experiment, part);
    for (std::size_t i = 0; i < experiment.samples.size(); ++i) {
      core::stopIfCancelled(progress);
      progress.report(static_cast<double>(i) / static_cast<double>(experiment.samples.size()),
                      "simulating " + experiment.samples[i].id);
      const fs::path file = part / json["samples"][i]["measurements"].get<std::string>();
      fs::create_directories(file.parent_path());
      core::writeDetections(file, simulate(experiment, model, i, {}, seed));
    }
    core::writeJson(part / "experiment.json", json);
    fs::remove_all(folder);
    fs::rename(part, folder);
  } catch (const fs::filesystem_error& error) {
    fs::remove_all(part);
    throw core::InputError({.file = folder}, std::string("cannot be written: ") + error.code().message() + ".",
                           "Check that its parent folder exists and that you may write there.");
  } catch (...) {
    fs::remove_all(part);
    throw;
  }
  progress.report(1.0, "done");
}

}  // namespace model
