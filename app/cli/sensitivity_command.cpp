#include <CLI/CLI.hpp>
#include <atomic>
#include <cmath>
#include <fmt/format.h>
#include <ostream>

#include "app/cli/commands.h"
#include "app/cli/sensitivity/design_file.h"
#include "app/cli/sensitivity/report.h"
#include "app/cli/sensitivity/varied_model.h"
#include "core/csv.h"
#include "core/error.h"
#include "core/parallel.h"
#include "core/text.h"
#include "metrics/distributions/edf.h"
#include "metrics/sensitivity/sensitivity_plan.h"
#include "model/external/external_runs.h"
#include "model/simulate.h"

namespace app {

namespace {

using Json = nlohmann::ordered_json;
using metrics::SensitivityPlan;
using metrics::UncertainParameter;

struct Options {
  std::string parameters;  // design
  std::string out;
  std::string design;  // analyze
  std::string outputs;
  std::string experiment;  // run
  std::string model;
  std::vector<std::string> vary;
  std::vector<std::string> samples;
  std::string gate;
  std::vector<std::string> columns;  // of outputs, or of detections
  std::size_t n = 1024;
  std::string method = "sobol";
  std::size_t curves = 4;
  IndexOptions indices;
};

SensitivityPlan planFor(std::vector<UncertainParameter> parameters, const Options& options, const Session& session) {
  const std::uint64_t seed = session.seed.value_or(1);
  return options.method == "fast" ? metrics::fastPlan(std::move(parameters), options.n, options.curves, seed)
                                  : metrics::sobolPlan(std::move(parameters), options.n, seed);
}

void design(const Options& options, const Session& session) {
  const SensitivityPlan plan = planFor(readParameters(options.parameters), options, session);
  writeDesign(options.out, plan);
  if (!session.quiet) session.messages << "wrote " << plan.rows.size() << " rows to " << options.out << "\n";
}

void analyze(const Options& options, const Session& session) {
  const SensitivityPlan plan = readDesign(options.design);
  const std::size_t rows = metrics::rowCount(plan);
  std::vector<std::vector<double>> columns = core::readNumericColumns(options.outputs, options.columns);
  std::vector<SensitivityOutput> outputs;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].size() != rows) {
      throw core::InputError({.file = options.outputs},
                             fmt::format("has {} rows, the design {} has {}.", columns[i].size(), options.design, rows),
                             "Give the outputs of every row of the design, in its order.");
    }
    outputs.push_back({.name = {{"name", options.columns[i]}}, .title = options.columns[i], .values = columns[i]});
  }
  Json document = headOfSensitivity(plan, options.indices, session);
  document["design"] = options.design;
  document["results"] = options.outputs;
  reportSensitivity(std::move(document), plan, outputs, options.indices, session);
}

/// POINTER=LOW:HIGH or POINTER=LOW:HIGH:log
UncertainParameter rangeOf(const std::string& text) {
  const auto fail = [&text] {
    throw core::InputError({.item = "--vary " + text}, "is no range.",
                           "Write POINTER=LOW:HIGH, or POINTER=LOW:HIGH:log for a parameter of many decades.");
  };
  const std::size_t equals = text.rfind('=');
  if (equals == std::string::npos) fail();
  UncertainParameter parameter{.name = text.substr(0, equals), .min = 0.0, .max = 0.0, .logarithmic = false};
  std::string range = text.substr(equals + 1);
  if (range.ends_with(":log")) {
    parameter.logarithmic = true;
    range.resize(range.size() - 4);
  }
  const std::size_t colon = range.find(':');
  if (colon == std::string::npos || !core::parseNumber(range.substr(0, colon), parameter.min) ||
      !core::parseNumber(range.substr(colon + 1), parameter.max)) {
    fail();
  }
  return parameter;
}

/// The outputs of a sample: mean and standard deviation of each column, and the number of detections.
std::vector<SensitivityOutput> outputsOfSample(const model::Experiment& experiment, std::size_t sample,
                                               const Options& options, std::size_t runs) {
  const std::string& id = experiment.samples[sample].id;
  std::vector<SensitivityOutput> outputs;
  const auto add = [&](const std::string& column, const char* statistic) {
    outputs.push_back({.name = {{"sample", id}, {"column", column}, {"statistic", statistic}},
                       .title = id + ": " + column + ", " + statistic,
                       .values = std::vector<double>(runs)});
  };
  for (const std::string& column : options.columns) {
    add(column, "mean");
    add(column, "standard_deviation");
  }
  add("detections", "count");
  return outputs;
}

/// The same numbers of one run; NaN where too few detections define them.
std::vector<double> numbersOf(const VariedModel::Variant& variant, std::size_t sample, const Options& options,
                              const Session& session) {
  const model::Experiment& experiment = variant.experiment;
  core::Detections detections = model::simulate(experiment, variant.model, sample, {}, session.seed);
  if (!options.gate.empty()) {
    const auto gate = std::find_if(experiment.gates.begin(), experiment.gates.end(),
                                   [&](const model::Gate& one) { return one.id == options.gate; });
    detections = model::insideGate(detections, model::situationOf(experiment, experiment.samples[sample]), *gate);
  }
  std::vector<double> numbers;
  for (const std::string& column : options.columns) {
    const std::vector<double>* values = detections.values(column);
    if (detections.size() == 0) {
      numbers.insert(numbers.end(), 2, std::nan(""));
      continue;
    }
    if (values == nullptr) {
      throw core::InputError({.item = "--column " + column}, "is not among the columns that the model puts out.",
                             "Choose range_m, or another one that the sensor profile reports.");
    }
    const metrics::Edf edf(*values);
    numbers.push_back(edf.mean());
    numbers.push_back(edf.standardDeviation());
  }
  numbers.push_back(static_cast<double>(detections.size()));
  return numbers;
}

std::vector<std::size_t> chosenSamples(const model::Experiment& experiment, const Options& options) {
  std::vector<std::size_t> chosen;
  for (const std::string& id : options.samples) chosen.push_back(experiment.sampleIndex(id));
  for (std::size_t i = 0; options.samples.empty() && i < experiment.samples.size(); ++i) chosen.push_back(i);
  return chosen;
}

void checkGate(const model::Experiment& experiment, const Options& options) {
  std::vector<std::string> ids;
  for (const model::Gate& gate : experiment.gates) ids.push_back(gate.id);
  if (options.gate.empty() || std::find(ids.begin(), ids.end(), options.gate) != ids.end()) return;
  throw core::InputError({.file = experiment.file, .item = "--gate " + options.gate}, "is not in the experiment.",
                         ids.empty() ? "It has no gates." : "It has " + core::join(ids) + ".");
}

void run(const Options& options, const Session& session) {
  std::vector<UncertainParameter> ranges;
  std::vector<std::string> pointers;
  for (const std::string& text : options.vary) {
    ranges.push_back(rangeOf(text));
    pointers.push_back(ranges.back().name);
  }
  const SensitivityPlan plan = planFor(ranges, options, session);
  const model::LidarModel model = model::readModel(options.model);
  model::requireBuiltIn(model, "'fidelis sensitivity' with --model");
  const VariedModel varied(model::readExperiment(options.experiment), model, pointers);
  checkGate(varied.experiment(), options);

  std::vector<std::vector<SensitivityOutput>> outputs;  // by sample
  const std::vector<std::size_t> samples = chosenSamples(varied.experiment(), options);
  for (const std::size_t sample : samples) {
    outputs.push_back(outputsOfSample(varied.experiment(), sample, options, plan.rows.size()));
  }
  std::atomic<std::size_t> done = 0;
  core::parallelFor(plan.rows.size(), 1, [&](std::size_t row, std::size_t) {
    core::stopIfCancelled(session.progress);
    const VariedModel::Variant variant = varied.at(plan.rows[row]);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const std::vector<double> numbers = numbersOf(variant, samples[i], options, session);
      for (std::size_t f = 0; f < numbers.size(); ++f) outputs[i][f].values[row] = numbers[f];
    }
    session.progress.report(static_cast<double>(++done) / static_cast<double>(plan.rows.size()), "simulating");
  });

  std::vector<SensitivityOutput> all;
  for (const std::vector<SensitivityOutput>& of_sample : outputs)
    all.insert(all.end(), of_sample.begin(), of_sample.end());
  Json document = headOfSensitivity(plan, options.indices, session);
  document["experiment"] = options.experiment;
  document["model"] = options.model;
  document["gate"] = options.gate.empty() ? Json(nullptr) : Json(options.gate);
  document["runs"] = plan.rows.size();
  document["varied"] = Json::array();
  for (const UncertainParameter& range : ranges) {
    document["varied"].push_back(
        {{"name", range.name}, {"min", range.min}, {"max", range.max}, {"logarithmic", range.logarithmic}});
  }
  reportSensitivity(std::move(document), plan, all, options.indices, session);
}

void addPlanOptions(CLI::App& command, Options& options) {
  command.add_option("--n", options.n, "Rows of a block: a power of two for sobol, at least 65 for fast")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command.add_option("--method", options.method, "sobol: n (k + 2) runs for k parameters; fast: n k runs a curve")
      ->check(CLI::IsMember({"sobol", "fast"}))
      ->capture_default_str();
  command.add_option("--curves", options.curves, "fast only: curves, 2 or more for intervals")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

void addIndexOptions(CLI::App& command, IndexOptions& options) {
  command.add_option("--first-order", options.first_order, "sobol only: estimator of the first-order index")
      ->check(CLI::IsMember({"saltelli", "jansen"}))
      ->capture_default_str();
  command.add_option("--replicates", options.replicates, "sobol only: bootstrap replicates for the intervals; 0: none")
      ->capture_default_str();
  command.add_option("--confidence", options.confidence, "Of the intervals")
      ->check(CLI::Range(0.5, 0.999))
      ->capture_default_str();
  command.add_option("--json", options.json, "Write the results as JSON to this file (-: standard output)");
}

template <typename Run>
void whenCalled(CLI::App& command, const std::shared_ptr<Options>& options, Session& session, Run run_it) {
  command.callback([options, &session, run_it] { run_it(*options, session); });
}

void addDesign(CLI::App& parent, Session& session) {
  auto options = std::make_shared<Options>();
  CLI::App& command = *parent.add_subcommand("design", "Write for which parameters a model is to be run");
  command.add_option("PARAMETERS", options->parameters, "Names and ranges (fidelis-parameters JSON)")->required();
  command.add_option("--out", options->out, "The design: a CSV file, one line a run")->required();
  addPlanOptions(command, *options);
  command.footer("Example:\n  fidelis sensitivity design parameters.json --n 1024 --out design.csv");
  whenCalled(command, options, session, design);
}

void addAnalyze(CLI::App& parent, Session& session) {
  auto options = std::make_shared<Options>();
  CLI::App& command = *parent.add_subcommand("analyze", "Compute indices from the outputs of all runs of a design");
  command.alias("analyse");
  command.add_option("DESIGN", options->design, "As written by 'design'")->required();
  command.add_option("OUTPUTS", options->outputs, "CSV with a header, one line for each row of the design")->required();
  command.add_option("--column", options->columns, "Column of OUTPUTS; may be repeated")
      ->required()
      ->allow_extra_args(false);
  addIndexOptions(command, options->indices);
  command.footer("Example:\n  fidelis sensitivity analyze design.csv outputs.csv --column y --json -");
  whenCalled(command, options, session, analyze);
}

void addRun(CLI::App& parent, Session& session) {
  auto options = std::make_shared<Options>();
  options->n = 64;
  CLI::App& command = *parent.add_subcommand("run", "Vary the built-in lidar and compute the indices of what it gives");
  command.add_option("EXPERIMENT", options->experiment, "Experiment package: a folder or its experiment.json")
      ->required();
  command.add_option("--model", options->model, "Model file (fidelis-model)")->required();
  command
      .add_option("--vary", options->vary,
                  "POINTER=LOW:HIGH[:log], a JSON Pointer into the model (/effects/…, /sensor/…) or the experiment "
                  "(/environment/…, /materials/…, /scene/…); may be repeated")
      ->required()
      ->allow_extra_args(false);
  command.add_option("--sample", options->samples, "Only these samples of the experiment; may be repeated")
      ->allow_extra_args(false);
  command.add_option("--gate", options->gate, "Only detections inside this gate");
  command.add_option("--column", options->columns, "Column of the detections, such as range_m; may be repeated")
      ->required()
      ->allow_extra_args(false);
  addPlanOptions(command, *options);
  addIndexOptions(command, options->indices);
  command.footer(
      "All runs share the model's seed (or --seed), and with it their noise.\n"
      "Example:\n"
      "  fidelis sensitivity run range-sweep --model model.json --sample r10 --column range_m --n 64 \\\n"
      "    --vary /materials/grey-board/reflectivity=0.05:0.9:log --vary /scene/0/pose/position_m/0=5:60");
  whenCalled(command, options, session, run);
}

}  // namespace

void addSensitivityCommand(CLI::App& program, Session& session) {
  CLI::App* command = program.add_subcommand(
      "sensitivity", "Which parameters matter: shares of an output's variance that each parameter brings");
  command->require_subcommand(1);
  command->footer(
      "first order: share that would vanish if the parameter were known. total: share that would remain if all\n"
      "others were known, interactions included; near 0 the parameter may be fixed and its samples be saved.\n"
      "Sources: Saltelli et al. 2010 and Jansen 1999 (sobol), Saltelli, Tarantola & Chan 1999 (fast).");
  addDesign(*command, session);
  addAnalyze(*command, session);
  addRun(*command, session);
}

}  // namespace app
