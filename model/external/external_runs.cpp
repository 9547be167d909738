#include "model/external/external_runs.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fmt/format.h>

#include "core/detection_files/detection_file.h"
#include "core/detection_files/detection_format.h"
#include "core/error.h"
#include "core/file.h"
#include "core/text.h"
#include "model/external/external_package.h"
#include "model/external/process.h"
#include "model/package_files.h"
#include "model/sensor/layers.h"

namespace model {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// -- a command

/// Where one run of a command takes place: package, output, log. Gone afterwards.
class Workshop {
 public:
  Workshop() {
    std::string name = (fs::temp_directory_path() / "fidelis-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
      throw core::InputError({.file = fs::temp_directory_path()}, "no folder can be made here.",
                             "Free some space, or name another folder in TMPDIR.");
    }
    path_ = name;
    fs::create_directories(experiment());
    fs::create_directories(out() / "measurements");
  }
  ~Workshop() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  [[nodiscard]] fs::path experiment() const { return path_ / "experiment"; }
  [[nodiscard]] fs::path out() const { return path_ / "out"; }
  [[nodiscard]] fs::path log() const { return path_ / "log"; }

 private:
  fs::path path_;
};

void replaceAll(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
}

std::vector<std::string> wordsOf(const ExternalModel& model, const Workshop& workshop, std::uint64_t seed) {
  std::vector<std::string> words = model.command;
  for (std::string& word : words) {
    replaceAll(word, "{experiment}", workshop.experiment().string());
    replaceAll(word, "{out}", workshop.out().string());
    replaceAll(word, "{seed}", std::to_string(seed));
  }
  return words;
}

fs::path folderOf(const LidarModel& model) {
  const fs::path folder = fs::absolute(model.file).parent_path();
  return folder.empty() ? fs::current_path() : folder;
}

core::Place commandOf(const LidarModel& model) { return {.file = model.file, .item = "command"}; }

/// The program's last words, as the end of a problem.
std::string lastWords(const Workshop& workshop) {
  const std::string text = lastLines(workshop.log());
  return text.empty() ? " It printed nothing." : " Its last words:\n" + text;
}

void requireSuccess(const LidarModel& model, const ProcessEnd& end, const Workshop& workshop) {
  const std::string& program = model.external->command.front();
  switch (end.kind) {
    case ProcessEnd::Kind::kExited:
      if (end.code == 0) return;
      throw core::InputError(commandOf(model),
                             fmt::format("'{}' ended with status {}.{}", program, end.code, lastWords(workshop)),
                             "Run it by hand in the folder of the model file.");
    case ProcessEnd::Kind::kKilled:
      throw core::InputError(commandOf(model),
                             fmt::format("'{}' was ended by signal {} ({}).{}", program, end.code,
                                         ::strsignal(end.code), lastWords(workshop)),
                             "Run it by hand in the folder of the model file.");
    case ProcessEnd::Kind::kNotStarted:
      throw core::InputError(commandOf(model),
                             fmt::format("'{}' cannot be started: {}.", program, std::strerror(end.code)),
                             "Give a program that is in PATH, or its place relative to the model file.");
    case ProcessEnd::Kind::kTimeOut:
      throw core::InputError(commandOf(model),
                             fmt::format("'{}' was ended after the time limit of {} s.{}", program,
                                         model.external->time_limit_s, lastWords(workshop)),
                             "Give it more time with time_limit_s, or simulate fewer frames.");
  }
}

/// The file that was asked for, or one of the same name with the ending of another format.
std::optional<fs::path> outputFor(const fs::path& asked) {
  if (fs::exists(asked)) return asked;
  for (const core::DetectionFormat& format : core::detectionFormats()) {
    for (const std::string& ending : format.endings) {
      const fs::path other = fs::path(asked).replace_extension(ending);
      if (fs::exists(other)) return other;
      if (fs::exists(other.string() + ".gz")) return other.string() + ".gz";
    }
  }
  return std::nullopt;
}

void requireOutputs(const LidarModel& model, const json& package, const Workshop& workshop) {
  constexpr std::size_t kNamed = 5;
  std::vector<std::string> missing;
  for (const json& sample : package.at("samples")) {
    const std::string file = sample.at("measurements");
    if (!outputFor(workshop.out() / file)) missing.push_back(file);
  }
  if (missing.empty()) return;
  const std::size_t count = missing.size();
  missing.resize(std::min(count, kNamed));
  throw core::InputError(
      commandOf(model),
      fmt::format("'{}' ended well, but did not write {}{}.{}", model.external->command.front(), core::join(missing),
                  count > kNamed ? fmt::format(" and {} more", count - kNamed) : "", lastWords(workshop)),
      "Write, below the output folder, the file that each sample names as `measurements`; of a "
      "sample without detections the header line.");
}

void checkFrames(const core::Detections& detections, int frames, const std::string& what, const core::Place& place) {
  const auto last = std::max_element(detections.frame.begin(), detections.frame.end());
  if (last == detections.frame.end() || *last < frames) return;
  throw core::InputError(place,
                         fmt::format("{} has a frame {}; the sample has {}, counted from 0.", what, *last, frames),
                         "Simulate as many frames as the sample asks for.");
}

ExternalRun readOutput(const Experiment& experiment, const LidarModel& model, const Sample& sample,
                       const std::string& name, const Workshop& workshop) {
  const fs::path file = *outputFor(workshop.out() / name);
  ExternalRun run{.detections = {}, .frames = sample.frames};
  try {
    run.detections = core::readDetections(file);
  } catch (const core::InputError& error) {  // the file is gone when the message is read
    core::Place place = error.place();
    place.file = file.lexically_relative(workshop.out());
    throw core::InputError({.file = model.file, .item = "command, output " + toString(place)}, error.problem(),
                           error.remedy());
  }
  if (run.detections.layer.empty()) addLayers(run.detections, beamsFired(experiment, sample));
  checkFrames(run.detections, sample.frames, "output " + name, commandOf(model));
  return run;
}

std::vector<ExternalRun> runCommand(const Experiment& experiment, const LidarModel& model,
                                    std::span<const WantedRun> wanted, const json& package, std::uint64_t seed,
                                    const core::Progress& progress) {
  const Workshop workshop;
  writeExternalPackage(experiment, wanted, package, workshop.experiment());
  const ProcessEnd end = runProcess({.words = wordsOf(*model.external, workshop, seed),
                                     .folder = folderOf(model),
                                     .log = workshop.log(),
                                     .time_limit_s = model.external->time_limit_s},
                                    progress);
  requireSuccess(model, end, workshop);
  requireOutputs(model, package, workshop);
  std::vector<ExternalRun> runs;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    runs.push_back(readOutput(experiment, model, experiment.samples.at(wanted[i].sample),
                              package.at("samples").at(i).at("measurements"), workshop));
  }
  return runs;
}

// -- recorded files

bool isRecorded(const Experiment& recording, const std::string& id) {
  return std::any_of(recording.samples.begin(), recording.samples.end(), [&](const Sample& s) { return s.id == id; });
}

/// A recording may have more frames than are asked for, not fewer.
ExternalRun readRecorded(const Experiment& recording, const Sample& wanted, const std::string& id) {
  const Sample& sample = recording.samples[recording.sampleIndex(id)];
  if (sample.frames < wanted.frames) {
    throw core::InputError({.file = recording.file, .item = "sample '" + id + "'"},
                           fmt::format("has {} frames recorded; {} are asked for.", sample.frames, wanted.frames),
                           "Record more, or ask for fewer in the experiment or the acceptance test.");
  }
  ExternalRun run{.detections = readMeasurements(recording, sample), .frames = wanted.frames};
  checkFrames(run.detections, sample.frames, "sample '" + id + "'", {.file = sample.measurements});
  std::vector<std::size_t> asked;
  for (std::size_t i = 0; i < run.detections.size(); ++i) {
    if (run.detections.frame[i] < wanted.frames) asked.push_back(i);
  }
  if (asked.size() < run.detections.size()) run.detections = core::selected(run.detections, asked);
  return run;
}

std::vector<ExternalRun> readRecording(const Experiment& experiment, const LidarModel& model,
                                       std::span<const WantedRun> wanted) {
  const Experiment recording = readExperiment(model.external->recorded);
  std::vector<ExternalRun> runs;
  for (const WantedRun& run : wanted) {
    const Sample& sample = experiment.samples.at(run.sample);
    runs.push_back(readRecorded(recording, sample, idOf(sample, run.offsets)));
  }
  return runs;
}

}  // namespace

std::vector<ExternalRun> ExternalRuns::run(const Experiment& experiment, const LidarModel& model,
                                           std::span<const WantedRun> wanted, std::uint64_t seed,
                                           core::Progress& progress) {
  if (!model.external->recorded.empty()) return readRecording(experiment, model, wanted);
  const json package = externalPackage(experiment, wanted, seed);
  const std::string key = core::sha256(package.dump() + "\n" + model.json.dump() + "\n" + folderOf(model).string() +
                                       "\n" + fs::absolute(experiment.file).string());
  const auto kept = kept_.find(key);
  if (kept != kept_.end()) return kept->second;
  progress.report(0.0, "running " + model.external->command.front());
  return kept_[key] = runCommand(experiment, model, wanted, package, seed, progress);
}

ExternalRun externalRun(const Experiment& experiment, const LidarModel& model, const WantedRun& wanted,
                        std::optional<std::uint64_t> seed) {
  core::SilentProgress nobody;
  return ExternalRuns().run(experiment, model, {&wanted, 1}, seed.value_or(model.seed), nobody).front();
}

std::vector<ExternalRun> nominalRuns(const Experiment& experiment, const LidarModel& model,
                                     std::optional<std::uint64_t> seed, core::Progress& progress) {
  if (!model.external) return {};
  std::vector<WantedRun> wanted;
  for (std::size_t i = 0; i < experiment.samples.size(); ++i) wanted.push_back({i, {}});
  return ExternalRuns().run(experiment, model, wanted, seed.value_or(model.seed), progress);
}

std::vector<EpistemicOffsets> cornersOf(const LidarModel& model, const Sample& sample) {
  std::vector<EpistemicOffsets> corners = epistemicCorners(sample);
  if (!model.external || model.external->recorded.empty()) return corners;
  const Experiment recording = readExperiment(model.external->recorded);
  std::vector<std::string> missing;
  for (std::size_t k = 1; k < corners.size(); ++k) {
    if (!isRecorded(recording, idOf(sample, corners[k]))) missing.push_back(idOf(sample, corners[k]));
  }
  if (missing.size() + 1 == corners.size()) {
    corners.resize(1);
  } else if (!missing.empty()) {
    throw core::InputError({.file = recording.file, .item = "/samples"},
                           "has some corners of sample '" + sample.id + "', but lacks " + core::join(missing) + ".",
                           "Record all corners of the epistemic box, or none.");
  }
  return corners;
}

std::vector<fs::path> filesOf(const LidarModel& model) {
  std::vector<fs::path> files;
  if (!model.external) return files;
  for (const std::string& word : model.external->command) {
    const fs::path file = model.file.parent_path() / word;
    if (fs::is_regular_file(file)) files.push_back(file);
  }
  if (model.external->recorded.empty()) return files;
  const Experiment recording = readExperiment(model.external->recorded);
  files.push_back(recording.file);
  for (const Sample& sample : recording.samples) {
    if (!sample.measurements.empty()) files.push_back(sample.measurements);
  }
  return files;
}

void requireBuiltIn(const LidarModel& model, const std::string& who) {
  if (!model.external) return;
  throw core::InputError({.file = model.file, .item = model.external->command.empty() ? "recorded" : "command"},
                         "is not the built-in lidar, which " + who + " needs: its effects are switched and fitted.",
                         "Use 'fidelis simulate', 'metric' or 'accept' for models of your own.");
}

}  // namespace model
