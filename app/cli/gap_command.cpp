#include <CLI/CLI.hpp>
#include <algorithm>
#include <ostream>

#include "acceptance/flips.h"
#include "app/cli/commands.h"
#include "core/error.h"
#include "core/file.h"
#include "core/json_object.h"
#include "core/text.h"
#include "gap/chain.h"
#include "gap/diagnosis.h"
#include "gap/report/html.h"
#include "gap/report/json.h"
#include "gap/report/text.h"
#include "percollect/read_graph.h"

namespace app {

namespace {

struct Options {
  std::string experiment;
  std::string model;
  std::string proxy;
  std::string library = "all";
  std::string without;
  std::string json;
  std::string html;
  std::string candidates;
  std::string graph;
  std::string write_model;
  std::string project;
};

std::vector<std::string> namesIn(const std::string& text) {
  std::vector<std::string> names;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t comma = std::min(text.find(',', at), text.size());
    names.push_back(core::trimmed(text.substr(at, comma - at)));
    at = comma + 1;
  }
  return names;
}

std::vector<std::string> libraryOf(const std::string& text) {
  if (text == "all") return {};
  std::vector<std::string> names = namesIn(text);
  std::vector<std::string> known;
  for (const model::EffectEntry& entry : model::allEffects()) known.push_back(entry.info.name);
  for (const std::string& name : names) {
    if (model::findEffect(name)) continue;
    const std::string nearest = core::nearestName(name, known);
    throw core::InputError(
        {.item = "--library"}, "'" + name + "' is not an effect of the library.",
        nearest.empty() ? "Known are " + core::join(known) + "." : "Did you mean '" + nearest + "'?");
  }
  return names;
}

/// The acceptance tests of a project that belong to the experiment, with the model as it is and as proposed.
std::vector<gap::TwiceJudgedTest> judgedTests(const specs::ProjectStore& project, const model::Experiment& experiment,
                                              const model::LidarModel& lidar, const gap::Diagnosis& diagnosis,
                                              Session& session) {
  if (diagnosis.approximation || diagnosis.proposed_model.is_null()) {
    session.messages << "fidelis: no acceptance test was judged again: "
                     << (diagnosis.approximation ? "the model under test is not the built-in lidar.\n"
                                                 : "the verdict names nothing that a model file can hold.\n");
    return {};
  }
  return acceptance::judgeTwice(project, experiment, {lidar, model::parseModel(diagnosis.proposed_model, lidar.file)},
                                session.seed, session.progress);
}

}  // namespace

void addGapCommand(CLI::App& program, Session& session) {
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "gap", "Diagnose the gap between a measurement and its re-simulation: where, which cause, how far it shrinks");
  command->add_option("EXPERIMENT", options->experiment, "Experiment package: a folder or its experiment.json")
      ->required();
  command->add_option("--model", options->model, "Model file (fidelis-model)")->required();
  command->add_option("--proxy", options->proxy, "Built-in model that stands for one that is a command or a recording");
  command->add_option("--library", options->library, "Effects to consider: all, or names joined by commas");
  command->add_option("--without", options->without,
                      "Leave out references, parameters or hold-out (joined by commas), to see what it brings; not for "
                      "verdicts");
  command->add_option("--json", options->json, "Write the report here; - for standard output");
  command->add_option("--html", options->html, "Write the report as a self-contained page");
  command->add_option("--candidates", options->candidates,
                      "Write every hypothesis that was tried as CSV: how well it explains, fitted values, and what "
                      "simpler judges say of it");
  command->add_option("--graph", options->graph, "Cause-effect graph (PerCollECT) in which the causes are looked up");
  command->add_option("--write-model", options->write_model, "Write the model with the cause that was found");
  command->add_option("--project", options->project,
                      "Project file: its acceptance tests of this experiment are judged with the proposed model too; "
                      "its graph serves if --graph names none");
  command->footer(
      "Examples:\n"
      "  fidelis gap foggy-sweep --model model.json --json report.json --write-model better.json\n"
      "  fidelis gap foggy-sweep --model model.json --project demo.fidelis --json report.json\n"
      "  fidelis gap foggy-sweep --model model.json --candidates tried.csv    what else was weighed\n"
      "  fidelis cepra propose report.json --project demo.fidelis      what follows for the relevance table");
  command->callback([options, &session] {
    const auto library = libraryOf(options->library);
    const std::vector<std::string> parts =
        options->without.empty() ? std::vector<std::string>{} : namesIn(options->without);
    const auto without = gap::Ablation::of(parts);
    const model::Experiment experiment = model::readExperiment(options->experiment);
    const model::LidarModel lidar = model::readModel(options->model);
    std::optional<percollect::Graph> graph;
    if (!options->graph.empty()) graph = percollect::readGraph(options->graph).graph;
    std::optional<specs::ProjectStore> project;
    if (!options->project.empty()) project = specs::ProjectStore::open(options->project, specs::Access::ReadOnly);
    if (project && !graph) graph = project->graph();
    gap::Diagnosis diagnosis = gap::diagnose(experiment, lidar,
                                             {.library = library,
                                              .seed = session.seed,
                                              .proxy = gap::chosenProxy(options->proxy, lidar),
                                              .list_tried = !options->candidates.empty(),
                                              .without = without},
                                             session.progress);
    if (graph) gap::addChains(diagnosis, *graph);
    if (project) {
      diagnosis.acceptance_tests = judgedTests(*project, experiment, lidar, diagnosis, session);
    }
    if (!options->candidates.empty()) core::writeFile(options->candidates, gap::toCsv(diagnosis.tried));
    if (!options->html.empty()) core::writeFile(options->html, gap::reportHtml(diagnosis));
    if (!options->json.empty()) session.writeJsonTo(options->json, gap::reportJson(diagnosis));
    if (options->json != "-") session.out << gap::reportText(diagnosis);
    if (options->write_model.empty()) return;
    if (diagnosis.approximation) {
      session.messages << "fidelis: no model file was written: the model under test is not the built-in lidar, so its "
                          "file names no effects. Build the cause into your model.\n";
    } else if (diagnosis.proposed_model.is_null()) {
      session.messages << "fidelis: no model file was written: the verdict names nothing that a model file can hold.\n";
    } else {
      core::writeJson(options->write_model, diagnosis.proposed_model);
    }
  });
}

}  // namespace app
