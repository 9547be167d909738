#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <ostream>

#include "app/cli/commands.h"
#include "core/error.h"
#include "core/file.h"
#include "core/text.h"
#include "core/version.h"
#include "objects/object_list.h"

namespace app {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct Options {
  std::string experiment;
  std::string out;
  bool reference = false;
  std::string stages;
  std::string gate;
  std::vector<std::string> samples;
  std::string reference_point = "centre";
  std::string json;
};

/// A sample's id as the name of its file.
std::string fileNameOf(const model::Experiment& experiment, const std::string& id) {
  if (id.find_first_of("/\\") == std::string::npos && id != "." && id != ".." && !id.empty()) return id + ".csv";
  throw core::InputError({.file = experiment.file, .item = "sample '" + id + "'"}, "is no name for a file.",
                         "Rename the sample: letters, digits, '-' and '_'.");
}

std::vector<std::size_t> samplesOf(const model::Experiment& experiment, const std::vector<std::string>& names) {
  std::vector<std::size_t> samples;
  for (const std::string& name : names) samples.push_back(experiment.sampleIndex(name));
  for (std::size_t i = 0; names.empty() && i < experiment.samples.size(); ++i) samples.push_back(i);
  return samples;
}

void mustBeNew(const fs::path& folder) {
  if (!fs::exists(folder) || (fs::is_directory(folder) && fs::is_empty(folder))) return;
  throw core::InputError({.file = folder}, "exists and is not an empty folder.", "Name a new folder for the lists.");
}

/// Name below the folder, content.
using Files = std::vector<std::pair<fs::path, std::string>>;

/// All of them or none.
void writeNew(const fs::path& folder, const Files& files) {
  try {
    for (const auto& [name, content] : files) {
      fs::create_directories((folder / name).parent_path());
      core::writeFile(folder / name, content);
    }
  } catch (const fs::filesystem_error& error) {
    std::error_code ignored;
    for (const auto& [name, content] : files) fs::remove(folder / name, ignored);
    throw core::InputError({.file = folder}, "cannot be written: " + error.code().message() + ".",
                           "Choose a folder that you may write to.");
  } catch (const core::InputError&) {
    std::error_code ignored;
    for (const auto& [name, content] : files) fs::remove(folder / name, ignored);
    throw;
  }
}

void tell(const Session& session, const objects::ObjectList& list, bool reference) {
  if (session.quiet) return;
  const objects::StageCounts& n = list.counts;
  session.messages << list.sample << ": "
                   << (reference
                           ? fmt::format("{} rows of reference objects in {} frames", list.objects.size(), list.frames)
                           : fmt::format("{} detections, {} outside the gate, {} ground, {} without object; "
                                         "{} rows of objects in {} frames",
                                         n.detections, n.outside_gate, n.ground, n.without_object, n.listed,
                                         list.frames))
                   << "\n";
  if (n.frames_without_ground > 0) {
    session.messages << "  no ground was found in " << n.frames_without_ground << " frames\n";
  }
}

void run(const Options& options, Session& session) {
  if (options.out.empty() && options.json.empty()) {
    throw core::InputError({.item = "--out"}, "is missing.", "Name a new folder, or --json FILE.");
  }
  if (!options.out.empty()) mustBeNew(options.out);
  const auto choice = *objects::ReferenceChoice::named(options.reference_point);
  const model::Experiment experiment = model::readExperiment(options.experiment);
  objects::Stages stages = options.stages.empty() ? objects::Stages{} : objects::readStages(options.stages);
  if (session.seed) stages.seed = *session.seed;
  Files files;
  ordered_json lists = ordered_json::array();
  const auto samples = samplesOf(experiment, options.samples);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    core::stopIfCancelled(session.progress);
    const model::Sample& sample = experiment.samples[samples[i]];
    session.progress.report(static_cast<double>(i) / static_cast<double>(samples.size()), "objects of " + sample.id);
    const std::string name = fileNameOf(experiment, sample.id);
    const objects::ObjectList truth = objects::referenceObjects(experiment, samples[i]);
    const objects::ObjectList list =
        options.reference ? truth
                          : objects::identifyObjects(experiment, samples[i],
                                                     model::readMeasurements(experiment, sample), stages, options.gate);
    files.emplace_back(name, objects::toCsv(list, choice, stages.reference));
    ordered_json entry = objects::toJson(list, choice, stages.reference);
    if (!options.reference) {
      const objects::ErrorOptions error_options{.reference = stages.reference};
      files.emplace_back(fs::path("errors") / name,
                         objects::toCsv(objects::errorsOf(list, truth, choice, error_options)));
      entry["stages"] = objects::toJson(list.counts);
    }
    lists.push_back(std::move(entry));
    tell(session, list, options.reference);
  }
  session.progress.report(1.0, "done");
  if (!options.out.empty()) writeNew(options.out, files);
  if (options.json.empty()) return;
  session.writeJsonTo(options.json, {{"format", "fidelis-objects"},
                                     {"version", 1},
                                     {"fidelis_version", core::kVersion},
                                     {"experiment", experiment.id},
                                     {"kind", options.reference ? "reference" : "identified"},
                                     {"stages", options.reference ? ordered_json() : ordered_json(stages.id)},
                                     {"seed", stages.seed},
                                     {"reference_point", choice.name()},
                                     {"samples", lists}});
}

}  // namespace

void addObjectsCommand(CLI::App& program, Session& session) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("objects", "Object lists from an experiment's detections, or from its scene");
  command->add_option("EXPERIMENT", options->experiment, "Experiment package, measured or simulated")->required();
  command->add_option("--out", options->out, "New folder: SAMPLE.csv, and errors/SAMPLE.csv against the scene");
  command->add_flag("--reference", options->reference, "List the scene's objects instead (ground truth)");
  command->add_option("--stages", options->stages, "File of format fidelis-object-stages; without it its defaults")
      ->excludes("--reference");
  command->add_option("--gate", options->gate, "Only detections in this gate of the experiment")
      ->excludes("--reference");
  command->add_option("--sample", options->samples, "Only these samples");
  command
      ->add_option("--reference-point", options->reference_point,
                   "What a position is the position of: " + core::join(objects::ReferenceChoice::names()))
      ->check(CLI::IsMember(objects::ReferenceChoice::names()).description(""))
      ->capture_default_str();
  command->add_option("--json", options->json, "Lists and what became of the detections, as JSON; - for the screen");
  command->footer(
      "Examples:\n"
      "  fidelis objects drive --out objects-real\n"
      "  fidelis simulate drive --model model.json --out simulated\n"
      "  fidelis objects simulated --out objects-sim\n"
      "  fidelis metric objects-real/s1.csv objects-sim/s1.csv --data tracks\n"
      "  fidelis metric objects-real/errors/s1.csv objects-sim/errors/s1.csv --column error_x_m");
  command->callback([options, &session] { run(*options, session); });
}

}  // namespace app
