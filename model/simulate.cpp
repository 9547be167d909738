#include "model/simulate.h"

#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <set>
#include <system_error>

#include "core/error.h"
#include "core/file.h"
#include "core/version.h"

namespace model {

namespace {

SignalChain chainOf(const LidarModel& model, const Sample& sample, const Environment& environment) {
  return {model.sensor(sample.sensor), model.effects, environment};
}

/// The scene as seen from the sensor at the moments of its beams.
RayTracer tracerOf(const Scene& scene, const SignalChain& chain, std::span<const Beam> beams) {
  const Vector3& own = chain.settings().sensor_velocity_m_s;
  if (own == Vector3{}) return RayTracer(scene, timesOf(beams));
  Scene relative = scene;
  for (SceneObject& object : relative.objects) {
    for (std::size_t k = 0; k < 3; ++k) object.velocity_m_s[k] -= own[k];
  }
  return RayTracer(relative, timesOf(beams));
}

/// Copies what the package refers to besides the measurements, keeping relative places.
void copyReferenced(const Experiment& experiment, const std::filesystem::path& folder) {
  for (const Sample& sample : experiment.samples) {
    for (const std::filesystem::path& file : filesOf(experiment, sample)) {
      if (file == experiment.file || file == sample.measurements) continue;
      const auto place = file.lexically_normal().lexically_relative(experiment.folder().lexically_normal());
      if (place.empty() || *place.begin() == "..") {
        throw core::InputError({.file = experiment.file, .item = "sample '" + sample.id + "'"},
                               "refers to " + file.string() + ", which lies outside the package.",
                               "Copy the file into the package: the simulated one takes its files along.");
      }
      std::filesystem::create_directories((folder / place).parent_path());
      std::filesystem::copy_file(file, folder / place, std::filesystem::copy_options::overwrite_existing);
    }
  }
}

/// A sample's id as the name of a file.
std::string fileNameOf(std::string id) {
  for (char& c : id) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' || c == '.';
    if (!plain) c = '_';
  }
  return id;
}

nlohmann::json simulatedExperimentJson(const Experiment& experiment, const LidarModel& model) {
  nlohmann::json json = experiment.json;
  json["source"] = "synthetic: simulated by fidelis " + std::string(core::kVersion) + " with the model '" + model.id +
                   "' after the experiment '" + experiment.id + "'";
  json.erase("columns");  // the simulated files have our own column names
  std::set<std::filesystem::path> written{"experiment.json"};
  for (std::size_t i = 0; i < experiment.samples.size(); ++i) {
    if (experiment.samples[i].measurements.empty()) {
      json["samples"][i]["measurements"] = "measurements/" + fileNameOf(experiment.samples[i].id) + ".csv";
    }
    const std::string file = json["samples"][i]["measurements"];
    if (!written.insert(std::filesystem::path(file).lexically_normal()).second) {
      throw core::InputError({.file = experiment.file, .item = "/samples/" + std::to_string(i) + "/measurements"},
                             "'" + file + "' would be written twice.", "Give every sample a file of its own.");
    }
  }
  return json;
}

}  // namespace

namespace {

core::InputError cannotWrite(const std::filesystem::path& folder, const std::error_code& code) {
  return {{.file = folder},
          "cannot be written: " + code.message() + ".",
          "Check that its parent folder exists and that you may write there."};
}

/// Absolute and without a slash at its end.
std::filesystem::path wholeName(const std::filesystem::path& folder) {
  const auto whole = std::filesystem::absolute(folder).lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();
}

/// A new folder of its own beside the one that is to appear, gone at the end unless it was renamed.
class PartFolder {
 public:
  explicit PartFolder(const std::filesystem::path& target) {
    std::string name = wholeName(target).string() + ".part-XXXXXX";
    if (::mkdtemp(name.data()) == nullptr) throw cannotWrite(target, {errno, std::generic_category()});
    path_ = name;
  }
  ~PartFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  PartFolder(const PartFolder&) = delete;
  PartFolder& operator=(const PartFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace

std::vector<Beam> beamsOfSample(const Experiment&, const LidarModel& model, const Sample& sample) {
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

BeamHits traceWith(const SignalChain& chain, const Scene& scene, std::vector<Beam> beams, const SubRays& rays) {
  const RayTracer tracer = tracerOf(scene, chain, beams);
  return traceBeams(tracer, std::move(beams), rays, chain.settings().sensor_position_m, chain.secondWays(scene));
}

core::Detections simulate(const Experiment& experiment, const LidarModel& model, std::size_t sample_index,
                          const EpistemicOffsets& offsets, std::optional<std::uint64_t> seed) {
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
    const RayTracer tracer = tracerOf(situation.scene, chain, beams);
    const GeometryPass pass(tracer, beams, rays, chain.settings().sensor_position_m, chain.secondWays(situation.scene));
    shots = chain.run(pass, situation.scene, options);
  }
  return toDetections(shots, nominal, model.sensor(sample.sensor));
}

void simulatePackage(const Experiment& experiment, const LidarModel& model, const std::filesystem::path& folder,
                     std::optional<std::uint64_t> seed, core::Progress& progress,
                     const std::function<void(const std::filesystem::path&)>& finish) {
  namespace fs = std::filesystem;
  if (fs::exists(folder) && (!fs::is_directory(folder) || !fs::is_empty(folder))) {
    throw core::InputError({.file = folder}, "exists and is not an empty folder.", "Name a new folder for the result.");
  }
  const nlohmann::json json = simulatedExperimentJson(experiment, model);
  const PartFolder part(folder);
  try {
    copyReferenced(experiment, part.path());
    for (std::size_t i = 0; i < experiment.samples.size(); ++i) {
      core::stopIfCancelled(progress);
      progress.report(static_cast<double>(i) / static_cast<double>(experiment.samples.size()),
                      "simulating " + experiment.samples[i].id);
      const fs::path file = part.path() / json["samples"][i]["measurements"].get<std::string>();
      fs::create_directories(file.parent_path());
      core::writeDetections(file, simulate(experiment, model, i, {}, seed));
    }
    core::writeJson(part.path() / "experiment.json", json);
    if (finish) finish(part.path());
    fs::permissions(part.path(),
                    fs::perms::others_read | fs::perms::others_exec | fs::perms::group_read | fs::perms::group_exec,
                    fs::perm_options::add);
    fs::rename(part.path(), wholeName(folder));  // takes the place of an empty folder, of no other
  } catch (const fs::filesystem_error& error) {
    throw cannotWrite(folder, error.code());
  }
  progress.report(1.0, "done");
}

}  // namespace model
