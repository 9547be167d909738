#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/validity/validity.h"

namespace app {

void addValidityCommand(CLI::App& program, Session& session) {
  CLI::App* command = program.add_subcommand(
      "validity", "Labels, fidelity gaps, tolerance checks and test frequencies: where is the model valid?");
  command->require_subcommand(1);
  addLabels(*command, session);
  addFidelityGap(*command, session);
  addToleranceCheck(*command, session);
  addPositiveTests(*command, session);
  command->footer(
      "Each has its own help: fidelis validity labels --help\n"
      "Exit status: 0 done (tolerance: all inside), 1 tolerance: a point is outside, 2 bad usage or input.\n\n"
      "Examples:\n"
      "  fidelis validity labels real.csv sim.csv --by sample --repetition frame --column range_m --column epw_m\n"
      "  fidelis validity gap levels.csv\n"
      "  fidelis validity tolerance real.csv sim.csv --over time_s --column range_m --relative 0.1 --absolute 0.02\n"
      "  fidelis validity ks real.csv sim.csv --by sample --column range_m");
}

}  // namespace app
