#include <CLI/CLI.hpp>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <ostream>
#include <set>

#include "app/cli/commands.h"
#include "core/csv.h"
#include "core/error.h"
#include "core/text.h"
#include "core/version.h"
#include "metrics/metric_catalog.h"

namespace app {

namespace {

struct Options {
  std::string real;
  std::vector<std::string> simulated;
  std::vector<std::string> columns;
  std::vector<std::string> units;
  std::vector<std::string> metrics;
  std::string shift = "one";
  std::optional<double> experiments;
  std::string json;
};

[[nodiscard]] metrics::Shift shiftOf(const Options& options) {
  return options.shift == "balanced" ? metrics::Shift::Balanced : metrics::Shift::One;
}

/// The metrics of one column, with what a reader needs to judge them.
struct Measurand {
  std::string name;
  std::string unit;
  std::size_t n_real = 0;
  std::vector<std::size_t> n_sim;
  std::vector<std::vector<double>> results;  ///< parallel to the chosen metrics
};

using Columns = std::vector<std::vector<double>>;
using Choice = std::vector<const metrics::Metric*>;

/// From the suffix of the column's name; "" if it has none that is known.
std::string unitOf(const std::string& column) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 13> kUnits{{
      {"_m_s", "m/s"},
      {"_m", "m"},
      {"_mm", "mm"},
      {"_cm", "cm"},
      {"_rad", "rad"},
      {"_deg", "deg"},
      {"_s", "s"},
      {"_ms", "ms"},
      {"_ns", "ns"},
      {"_nw", "nW"},
      {"_w", "W"},
      {"_hz", "Hz"},
      {"intensity", "nW"},
  }};
  const std::string name = core::lowerCase(column);
  for (const auto& [suffix, unit] : kUnits) {
    if (name.ends_with(suffix)) return std::string(unit);
  }
  return "";
}

void checkColumns(const Options& options) {
  std::set<std::string> seen;
  for (const std::string& column : options.columns) {
    if (!seen.insert(column).second) {
      throw core::InputError({.item = "--column " + column}, "is given twice.", "Give every column once.");
    }
  }
  if (options.units.size() > 1 && options.units.size() != options.columns.size()) {
    throw core::InputError(
        {.item = "--unit"},
        fmt::format("is given {} times for {} columns.", options.units.size(), options.columns.size()),
        "Give one unit for all, or one for each --column in the same order.");
  }
}

Choice choiceOf(const Options& options) {
  Choice choice;
  if (options.metrics.empty()) {
    for (const metrics::Metric& metric : metrics::metricCatalog()) choice.push_back(&metric);
  }
  for (const std::string& name : options.metrics) choice.push_back(&metrics::metricNamed(name));
  return choice;
}

Columns readColumns(const std::string& file, const Options& options) {
  Columns columns = core::readNumericColumns(file, options.columns);
  if (columns.front().empty()) {
    throw core::InputError({.file = file}, "has a header and no rows; nothing can be compared.",
                           "Check the export, or leave the file out.");
  }
  return columns;
}

std::vector<std::vector<double>> evaluate(const metrics::MetricInput& input, const Choice& choice) {
  std::vector<std::vector<double>> results;
  for (const metrics::Metric* metric : choice) results.push_back(metric->compute(input));
  return results;
}

std::string unitOf(const Options& options, std::size_t index) {
  if (options.units.empty()) return unitOf(options.columns[index]);
  return options.units[options.units.size() == 1 ? 0 : index];
}

/// Takes the numbers of column `index` out of the files.
Measurand compare(Columns& real, std::vector<Columns>& simulated, std::size_t index, const Options& options,
                  const Choice& choice) {
  Measurand measurand{.name = options.columns[index],
                      .unit = unitOf(options, index),
                      .n_real = real[index].size(),
                      .n_sim = {},
                      .results = {}};
  std::vector<double> pooled;
  std::vector<metrics::Edf> runs;
  for (Columns& run : simulated) {
    measurand.n_sim.push_back(run[index].size());
    if (simulated.size() > 1) pooled.insert(pooled.end(), run[index].begin(), run[index].end());
    runs.emplace_back(std::move(run[index]));
  }
  const metrics::Edf measured(std::move(real[index]));
  const metrics::PBox measured_box(measured);
  const metrics::PBox box = metrics::PBox::envelope(runs);
  if (simulated.size() > 1) runs = {metrics::Edf(std::move(pooled))};
  const metrics::MetricInput input({.simulated = box, .measured = measured_box},
                                   {.simulated = runs.front(), .measured = measured},
                                   {.shift = shiftOf(options), .experiments = options.experiments});
  measurand.results = evaluate(input, choice);
  return measurand;
}

nlohmann::ordered_json jsonOf(const metrics::Metric& metric, const std::vector<double>& result) {
  if (metric.shape == metrics::MetricShape::Number) return result.front();
  if (metric.shape == metrics::MetricShape::List) return result;
  nlohmann::ordered_json object = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < result.size(); ++i) object[std::string(metric.parts[i])] = result[i];
  return object;
}

nlohmann::ordered_json documentOf(const std::vector<Measurand>& measurands, const Options& options,
                                  const Choice& choice) {
  nlohmann::ordered_json document{{"format", "fidelis-metric"}, {"version", 1}, {"fidelis_version", core::kVersion}};
  document["real"] = options.real;
  document["simulated"] = options.simulated;
  document["options"]["shift"] = options.shift;
  document["options"]["experiments"] = nullptr;
  if (options.experiments) document["options"]["experiments"] = *options.experiments;
  document["measurands"] = nlohmann::ordered_json::array();
  for (const Measurand& measurand : measurands) {
    nlohmann::ordered_json entry{{"name", measurand.name}, {"unit", measurand.unit}, {"n_real", measurand.n_real}};
    entry["n_sim"] = measurand.n_sim;
    for (std::size_t i = 0; i < choice.size(); ++i) {
      entry[std::string(choice[i]->info.name)] = jsonOf(*choice[i], measurand.results[i]);
    }
    document["measurands"].push_back(std::move(entry));
  }
  return document;
}

std::string numberForReader(double value) { return std::isnan(value) ? "-" : core::significant(value, 6); }

std::string valueForReader(const std::vector<double>& result) {
  if (result.size() == 1) return numberForReader(result.front());
  std::vector<std::string> parts;
  for (const double value : result) parts.push_back(numberForReader(value));
  return "[" + core::join(parts) + "]";
}

void writeTable(const std::vector<Measurand>& measurands, const Choice& choice, std::ostream& out) {
  for (const Measurand& measurand : measurands) {
    std::vector<std::string> sizes;
    for (const std::size_t n : measurand.n_sim) sizes.push_back(std::to_string(n));
    out << fmt::format("{}: n = {} measured, {} simulated{}\n", measurand.name, measurand.n_real,
                       core::join(sizes, " + "), sizes.size() > 1 ? " (p-box)" : "");
    out << fmt::format("  {:<18} {:>24}  {:<5} {}\n", "metric", "value", "unit", "meaning");
    for (std::size_t i = 0; i < choice.size(); ++i) {
      const bool has_unit = choice[i]->info.unit == metrics::MetricUnit::Measurand && !measurand.unit.empty();
      out << fmt::format("  {:<18} {:>24}  {:<5} {}\n", choice[i]->info.name, valueForReader(measurand.results[i]),
                         has_unit ? measurand.unit : "-", choice[i]->info.meaning);
    }
  }
}

void runMetric(const Options& options, const Session& session) {
  checkColumns(options);
  const Choice choice = choiceOf(options);  // a misspelt name is told before anything large is read
  Columns real = readColumns(options.real, options);
  std::vector<Columns> simulated;
  for (const std::string& file : options.simulated) {
    if (session.progress.cancelled()) throw core::Cancelled();
    simulated.push_back(readColumns(file, options));
  }
  std::vector<Measurand> measurands;
  for (std::size_t i = 0; i < options.columns.size(); ++i) {
    measurands.push_back(compare(real, simulated, i, options, choice));
  }
  if (options.json.empty()) {
    writeTable(measurands, choice, session.out);
  } else {
    session.writeJsonTo(options.json, documentOf(measurands, options, choice));
  }
}

std::string footer() {
  std::string text =
      "Several SIM files are runs with different epistemic assumptions: their envelope is a p-box. The differences of\n"
      "mean, median and standard deviation, wasserstein_1 and ks know no p-box; they take all simulated values "
      "pooled.\n"
      "A positive d_bias means that the simulation is too high.\n\nMetrics:\n";
  for (const metrics::Metric& metric : metrics::metricCatalog()) {
    text += fmt::format("  {:<18} {}\n", metric.info.name, metric.info.meaning);
  }
  return text +
         "\nExamples:\n"
         "  fidelis metric real.csv sim.csv --column range_m\n"
         "  fidelis metric real.csv.gz corner-*.csv --column range_m --column epw_m --json result.json\n"
         "  fidelis metric real.csv sim.csv --column Distance --unit m --metric d_bias,d_cavm --json -";
}

void addOptions(CLI::App& command, Options& options) {
  command.add_option("REAL", options.real, "Measured values: a CSV file with a header line; gzip is understood")
      ->required();
  command.add_option("SIM", options.simulated, "Simulated values: one CSV file, or several that make a p-box")
      ->required();
  command.add_option("--column", options.columns, "Column to compare, by its name in the header; may be repeated")
      ->required()
      ->allow_extra_args(false);
  command
      .add_option("--unit", options.units,
                  "Unit, one for all or one for each --column; without it told by the name's suffix (_m, _rad, …)")
      ->allow_extra_args(false);
  command.add_option("--metric", options.metrics, "Only these metrics, in this order; may be repeated or a,b,c")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      .add_option("--shift", options.shift, "How dvm removes the bias: one shift, as published, or the balanced one")
      ->check(CLI::IsMember({"one", "balanced"}))
      ->capture_default_str();
  command
      .add_option("--experiments", options.experiments,
                  "Replications of the experiment, for the safety factor of d_mavm; without it n of REAL")
      ->check(CLI::PositiveNumber);
  command.add_option("--json", options.json, "Write the results as JSON to this file (-: standard output)");
}

}  // namespace

void addMetricCommand(CLI::App& program, Session& session) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("metric", "Compare measured and simulated values: how far apart are they?");
  addOptions(*command, *options);
  command->footer(footer());
  command->callback([options, &session] { runMetric(*options, session); });
}

}  // namespace app
