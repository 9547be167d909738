#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/predict/box_output.h"
#include "app/cli/predict/output.h"
#include "core/file.h"

namespace app {

namespace {

void runPredict(const PredictRequest& request, const Session& session) {
  const Outcome outcome = outcomeOf(request);
  if (!session.quiet) writeRemarks(outcome, request, session.messages);
  const auto document = documentOf(outcome, request);
  if (!request.boxes.csv.empty()) core::writeFile(request.boxes.csv, edgesAsCsv(*outcome.boxes));
  if (!request.save.empty()) session.writeJsonTo(request.save, document);
  if (!request.json.empty()) session.writeJsonTo(request.json, document);
  if (request.json.empty() && request.save != "-") writeTable(outcome, request, session.out);
}

const char* const kFooter =
    "RESULTS is a CSV file, one row a validated sample, or the report of 'fidelis accept --json' (*.json). Rows of\n"
    "role 'prediction' are held out and checked, rows of role 'calibration' are not used. Cross-validation keeps rows\n"
    "of one set-up together. d_cavm, d_avm, d_plus and d_minus are never predicted below 0.\n\n"
    "Families: constant, linear, quadratic, exponential (a + b exp(c x)), sigmoid. 'auto' takes the one that best\n"
    "predicts what it has not seen.\n\n"
    "With --simulated, boxes of the values simulated at the one point of --at: the expected one, corrected by the\n"
    "predicted d_bias and d_cavm, with its bound; and the aggregated one (input, model form, numerical part), not\n"
    "corrected but widened, if d_plus and d_minus were predicted. The column is the measurand of the errors.\n\n"
    "Examples:\n"
    "  fidelis predict results.csv --over range_m --at range_m=12.4\n"
    "  fidelis predict results.csv --over range_m,angle_deg --for d_bias --measurand epw --save prediction.json\n"
    "  fidelis predict --with prediction.json --at range_m=20,angle_deg=30 --json -\n"
    "  fidelis predict report.json --test EchoPulseWidthError_Fog_2 --over range_m --at-file queries.csv\n"
    "  fidelis predict results.csv --over range_m --for d_bias,d_cavm,d_plus,d_minus --save prediction.json\n"
    "  fidelis predict --with prediction.json --at range_m=40 --simulated sim-*.csv --column range_m --numerical 0.002";

void addLearning(CLI::App& command, PredictRequest& request) {
  command.add_option("RESULTS", request.results, "Validation results: CSV, or a JSON report of 'fidelis accept'");
  command.add_option("--over", request.columns.parameters, "Parameters to predict over, by their columns: a,b,c")
      ->delimiter(',')
      ->allow_extra_args(false);
  command.add_option("--for", request.columns.targets, "Errors to predict, by their columns (default: d_bias,d_cavm)")
      ->delimiter(',')
      ->allow_extra_args(false);
  command.add_option("--family", request.family, "Shape of the function")
      ->check(CLI::IsMember({"auto", "constant", "linear", "quadratic", "exponential", "sigmoid"}))
      ->capture_default_str();
  command
      .add_option("--folds", request.folds,
                  "Folds of the cross-validation; 0: leave one set-up out, or 10 of more than 50 set-ups")
      ->capture_default_str();
  command.add_option("--setup", request.columns.setup, "Column of the set-up (default: setup, if there is one)");
  command.add_option("--role", request.columns.role, "Column of the role (default: role, if there is one)");
  command.add_option("--weight", request.columns.weight, "Column of weights, proportional to 1 / variance");
  command.add_option("--test", request.test, "Test of the acceptance report whose samples are used");
}

void addAsking(CLI::App& command, PredictRequest& request) {
  command.add_option("--with", request.with, "Ask this saved prediction in place of RESULTS");
  command.add_option("--level", request.level, "Level of the bounds (default: 0.95, or as saved)")
      ->check(CLI::Range(0.0, 1.0));
  command.add_option("--at", request.at, "Where to predict: range_m=12.4,angle_deg=30; may be repeated")
      ->allow_extra_args(false);
  command.add_option("--at-file", request.at_file, "Where to predict: a CSV file with a column for each parameter");
  command.add_option("--measurand", request.measurand,
                     "Whose errors these are, recorded in --save: name or column, range or range_m (default: as the "
                     "report or the saved prediction says)");
  command.add_option("--held-out", request.held_out, "Check the prediction on the results of this CSV file");
  command.add_option("--save", request.save, "Write the prediction to this JSON file, to be asked again");
  command.add_option("--json", request.json, "Write prediction and answers as JSON (-: standard output)");
}

void addBoxes(CLI::App& command, BoxRequest& request) {
  CLI::Option* simulated = command.add_option("--simulated", request.simulated,
                                              "Make boxes of what was simulated at the one point of --at: CSV files, "
                                              "several make an envelope");
  command.add_option("--column", request.column, "Column of the simulated values")->needs(simulated);
  command
      .add_option("--numerical", request.numerical,
                  "Numerical uncertainty, appended to both edges of the aggregated box")
      ->check(CLI::NonNegativeNumber)
      ->needs(simulated)
      ->capture_default_str();
  command
      .add_option("--bounds", request.bounds,
                  "What the bound of the expected box holds: the mean error (confidence), or one more sample")
      ->check(CLI::IsMember({"confidence", "observation"}))
      ->needs(simulated)
      ->capture_default_str();
  command
      .add_option("--model-form", request.model_form,
                  "What is appended to the aggregated box: d_minus below and d_plus above (portions), or d_avm on both "
                  "sides (area); upper bounds for one more sample. Default: portions, if they were predicted")
      ->check(CLI::IsMember({"portions", "area"}))
      ->needs(simulated);
  command.add_option("--box-csv", request.csv, "Write both edges of every box to this CSV file")->needs(simulated);
}

}  // namespace

void addPredictCommand(CLI::App& program, Session& session) {
  auto request = std::make_shared<PredictRequest>();
  CLI::App* command =
      program.add_subcommand("predict", "Predict the error of a simulation where nobody measured, with bounds");
  addLearning(*command, *request);
  addAsking(*command, *request);
  addBoxes(*command, request->boxes);
  command->footer(kFooter);
  command->callback([request, &session] { runPredict(*request, session); });
}

}  // namespace app
