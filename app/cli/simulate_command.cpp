#include <CLI/CLI.hpp>
#include <ostream>

#include "app/cli/commands.h"
#include "model/simulate.h"

namespace app {

namespace {
struct Options {
  std::string experiment;
  std::string model;
  std::string out;
};
}  // namespace

void addSimulateCommand(CLI::App& program, Session& session) {
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("simulate", "Re-simulate an experiment package with the built-in lidar");
  command->add_option("EXPERIMENT", options->experiment, "Experiment package: a folder or its experiment.json")
      ->required();
  command->add_option("--model", options->model, "Model file (fidelis-model)")->required();
  command->add_option("--out", options->out, "New folder that becomes an experiment package: same files, simulated")
      ->required();
  command->footer("Example:\n  fidelis simulate range-sweep --model model.json --out simulated");
  command->callback([options, &session] {
    const model::Experiment experiment = model::readExperiment(options->experiment);
    const model::LidarModel lidar = model::readModel(options->model);
    model::simulatePackage(experiment, lidar, options->out, session.seed, session.progress);
    if (!session.quiet) {
      session.messages << "simulated " << experiment.samples.size() << " samples of '" << experiment.id << "' into "
                       << options->out << "\n";
    }
  });
}

}  // namespace app
