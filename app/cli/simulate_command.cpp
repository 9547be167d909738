#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <ostream>

#include "app/cli/commands.h"
#include "app/cli/effects_in_reflections.h"
#include "model/simulate.h"
#include "prediction/annotate.h"

namespace app {

namespace {

struct Options {
  std::string experiment;
  std::string model;
  std::string out;
  std::vector<std::string> predictions;
  prediction::AnnotateOptions annotate;
  std::string bounds = "confidence";
  model::PackageReflections reflections;
};

prediction::Annotation annotationOf(const Options& options, const model::Experiment& experiment) {
  std::vector<prediction::PredictionFile> files;
  for (const std::string& file : options.predictions) files.push_back(prediction::readPredictionFile(file));
  prediction::AnnotateOptions how = options.annotate;
  how.bounds = options.bounds == "observation" ? metrics::BoundOf::Observation : metrics::BoundOf::Confidence;
  return {experiment, std::move(files), how};
}

void writeCounts(const std::vector<prediction::AnnotatedCounts>& counts, std::ostream& messages) {
  for (const prediction::AnnotatedCounts& count : counts) {
    messages << fmt::format(
        "predicted errors of {} ({} … {}) beside {} detections: {} extrapolated, {} at unknown points\n",
        count.measurand, count.columns.front(), count.columns.back(), count.detections, count.outside, count.unknown);
  }
}

void runSimulate(const Options& options, const Session& session) {
  const model::Experiment experiment = model::readExperiment(options.experiment);
  const model::LidarModel lidar = model::readModel(options.model);
  const prediction::Annotation annotation = annotationOf(options, experiment);
  std::vector<prediction::AnnotatedCounts> counts;
  model::simulatePackage(
      experiment, lidar, options.out, session.seed, session.progress,
      [&](const std::filesystem::path& folder) { counts = annotation.apply(folder); }, options.reflections);
  if (session.quiet) return;
  session.messages << "simulated " << experiment.samples.size() << " samples of '" << experiment.id << "' into "
                   << options.out << "\n";
  if (!options.reflections.from.empty()) writeEffectsInReflections(lidar, session.messages);
  writeCounts(counts, session.messages);
}

const char* const kFooter =
    "With --prediction each detection gets the error that 'fidelis predict --save' predicts at its point of the\n"
    "parameter space: range_m_bias, range_m_bias_low, range_m_bias_high … and range_m_extrapolated (0: inside the\n"
    "samples, 1: a parameter beyond them, 2: no sample near the combination, 3: the point is not known, nothing is\n"
    "predicted). A parameter is looked up among the samples' parameters, then the detection's own values (range_m,\n"
    "azimuth_deg, layer …), then the environment; one place for the whole package.\n\n"
    "With --reflections each sample gets reflections/ID.osi besides: an ASAM OSI 3 trace of SensorView with what "
    "every\n"
    "sub-ray brought back, to feed a reflection-based lidar model elsewhere. With --from-reflections such traces, "
    "from\n"
    "wherever they come, take the place of the own ones; what they hold is received by the sensor as if it were its\n"
    "own. Effects that change the power of a reflection are then left out: they are in the signal strengths.\n\n"
    "Examples:\n"
    "  fidelis simulate range-sweep --model model.json --out simulated\n"
    "  fidelis simulate range-sweep --model model.json --reflections --out simulated\n"
    "  fidelis simulate range-sweep --model model.json --from-reflections traces --out received\n"
    "  fidelis simulate range-sweep --model model.json --prediction prediction.json --out simulated\n"
    "  fidelis simulate crossing --model model.json --prediction prediction.json --coordinate range_m=detection \\\n"
    "      --out simulated";

void addPrediction(CLI::App& command, Options& options) {
  CLI::Option* files = command.add_option("--prediction", options.predictions,
                                          "Write the errors that these saved predictions predict with each detection");
  command
      .add_option("--measurand", options.annotate.measurand,
                  "Whose errors they are, for predictions that do not record it: name or column")
      ->needs(files);
  command
      .add_option(
          "--coordinate", options.annotate.coordinates,
          "Where a parameter is looked up: NAME=sample, NAME=detection or NAME=environment, with :KEY if it has "
          "another name there; may be repeated")
      ->allow_extra_args(false)
      ->needs(files);
  command
      .add_option("--bounds", options.bounds,
                  "What low and high bound: the mean error (confidence), or that of one more sample (observation)")
      ->check(CLI::IsMember({"confidence", "observation"}))
      ->needs(files)
      ->capture_default_str();
}

void addReflections(CLI::App& command, Options& options) {
  CLI::Option* write = command.add_flag("--reflections", options.reflections.write,
                                        "Write the sub-rays' reflections too, as ASAM OSI 3 traces of SensorView");
  command
      .add_option("--from-reflections", options.reflections.from,
                  "Take the reflections from here: a folder with ID.osi for each sample, a package that was written "
                  "with --reflections, or the trace of the only sample")
      ->excludes(write);
}

}  // namespace

void addSimulateCommand(CLI::App& program, Session& session) {
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("simulate", "Re-simulate an experiment package with the built-in lidar");
  command->add_option("EXPERIMENT", options->experiment, "Experiment package: a folder or its experiment.json")
      ->required();
  command->add_option("--model", options->model, "Model file (fidelis-model)")->required();
  command->add_option("--out", options->out, "New folder that becomes an experiment package: same files, simulated")
      ->required();
  addPrediction(*command, *options);
  addReflections(*command, *options);
  command->footer(kFooter);
  command->callback([options, &session] { runSimulate(*options, session); });
}

}  // namespace app
