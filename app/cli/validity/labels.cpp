#include <CLI/CLI.hpp>
#include <array>
#include <fmt/format.h>
#include <map>
#include <ostream>

#include "app/cli/metric/request.h"
#include "app/cli/validity/output.h"
#include "app/cli/validity/read.h"
#include "app/cli/validity/validity.h"
#include "core/error.h"
#include "core/text.h"
#include "metrics/validity/viehof.h"

namespace app {

using metrics::ValidityLabel;
using nlohmann::ordered_json;

namespace {

constexpr Method kMethod{
    .kind = "labels",
    .title = "Labels by tolerance intervals of the t-distribution, and the validity assessment map",
    .source = "Viehof 2018, dissertation, TU Darmstadt (labels and map); thresholds: choice of this program"};

constexpr std::array<ValidityLabel, 4> kLabels{ValidityLabel::Green, ValidityLabel::Yellow, ValidityLabel::Red,
                                               ValidityLabel::Black};

std::string_view wordOf(ValidityLabel label) {
  constexpr std::array<std::string_view, 4> kWords{"green", "yellow", "red", "black"};
  return kWords[static_cast<std::size_t>(label) - 1];
}

struct Request {
  std::string real;
  std::string simulated;
  std::string by = "sample";
  std::string repetition;
  std::vector<std::string> columns;
  std::vector<std::string> units;
  metrics::ViehofOptions options;
  std::string json;

  [[nodiscard]] std::vector<std::string> keys() const {
    return repetition.empty() ? std::vector{by} : std::vector{by, repetition};
  }
  [[nodiscard]] std::string unitOf(std::size_t column) const {
    return units.empty() ? unitOfName(columns[column]) : units[units.size() == 1 ? 0 : column];
  }
};

struct Cell {
  std::size_t n_real;
  std::size_t n_sim;
  metrics::ViehofResult result;
};

struct Labels {
  metrics::ValidityMap map;
  std::vector<std::vector<Cell>> cells;  ///< sample by sample, one a measurand

  [[nodiscard]] std::size_t count(ValidityLabel label) const {
    std::size_t n = 0;
    for (const auto& row : cells) {
      for (const Cell& cell : row) n += cell.result.label == label ? 1 : 0;
    }
    return n;
  }
};

/// One value a repetition: the mean of its rows, or the row itself.
std::vector<double> repetitionsOf(const KeyedRows& rows, std::size_t column, const std::vector<std::size_t>& chosen) {
  if (rows.keys.size() < 2) return numbersOf(rows, column, chosen);
  std::map<std::string, std::vector<double>> by_repetition;
  for (const std::size_t row : chosen) by_repetition[rows.keys[1][row]].push_back(rows.numbers[column][row]);
  std::vector<double> means;
  for (auto& [name, values] : by_repetition) means.push_back(metrics::Edf(std::move(values)).mean());
  return means;
}

Cell cellOf(const KeyedRows& real, const KeyedRows& simulated, const GroupPair& sample, std::size_t column,
            const Request& request) {
  const metrics::Edf measured(repetitionsOf(real, column, sample.real));
  const metrics::Edf model(repetitionsOf(simulated, column, sample.simulated));
  if (measured.n() < 2) {
    throw core::InputError(
        {.file = request.real, .line = real.lines[sample.real.front()], .item = request.by + " '" + sample.name + "'"},
        "has a single repetition; its scatter is not known.",
        request.repetition.empty() ? "Repeat the experiment, or check --by."
                                   : "Repeat the experiment, or check --repetition.");
  }
  return {.n_real = measured.n(),
          .n_sim = model.n(),
          .result = viehofLabel({.simulated = model, .measured = measured}, request.options)};
}

/// A map with holes would hide what nobody simulated.
void mustHaveBothSides(const std::vector<GroupPair>& samples, const KeyedRows& real, const KeyedRows& simulated,
                       const Request& request) {
  for (const GroupPair& sample : samples) {
    if (!sample.real.empty() && !sample.simulated.empty()) continue;
    const bool lonely_real = sample.simulated.empty();
    const KeyedRows& here = lonely_real ? real : simulated;
    const KeyedRows& there = lonely_real ? simulated : real;
    std::vector<std::string> others;
    for (const GroupPair& other : samples) {
      if ((lonely_real ? other.real : other.simulated).empty()) others.push_back(other.name);
    }
    const std::string nearest = core::nearestName(sample.name, others);
    throw core::InputError({.file = here.file,
                            .line = here.lines[(lonely_real ? sample.real : sample.simulated).front()],
                            .item = request.by + " '" + sample.name + "'"},
                           "is not in " + there.file + ".",
                           nearest.empty()
                               ? "Add it there, or take its rows out here: the map leaves nothing out silently."
                               : "Is it '" + nearest + "' there? Write both alike.");
  }
}

Labels labelsOf(const KeyedRows& real, const KeyedRows& simulated, const Request& request) {
  const std::vector<GroupPair> samples = pairedGroups(real, simulated);
  mustHaveBothSides(samples, real, simulated, request);
  std::vector<std::string> names;
  for (const GroupPair& sample : samples) names.push_back(sample.name);
  Labels labels{.map = metrics::ValidityMap(names, request.columns), .cells = {}};
  for (std::size_t i = 0; i < samples.size(); ++i) {
    labels.cells.emplace_back();
    for (std::size_t k = 0; k < request.columns.size(); ++k) {
      labels.cells[i].push_back(cellOf(real, simulated, samples[i], k, request));
      labels.map.at(i, k) = labels.cells[i][k].result.label;
    }
  }
  return labels;
}

std::string numberAndWord(ValidityLabel label) { return fmt::format("{} {}", static_cast<int>(label), wordOf(label)); }

std::string intervalText(const metrics::ToleranceInterval& interval) {
  return fmt::format("[{}, {}]", core::significant(interval.low, 5), core::significant(interval.high, 5));
}

std::string countsText(const Labels& labels) {
  std::vector<std::string> counts;
  for (const ValidityLabel label : kLabels) counts.push_back(fmt::format("{} {}", labels.count(label), wordOf(label)));
  return core::join(counts);
}

void writeMap(const Labels& labels, const Request& request, std::ostream& out) {
  std::vector<std::vector<std::string>> table{{request.by}};
  for (const std::string& column : request.columns) table[0].push_back(column);
  table[0].emplace_back("worst");
  for (std::size_t i = 0; i < labels.cells.size(); ++i) {
    table.push_back({labels.map.parameterSamples()[i]});
    for (const Cell& cell : labels.cells[i]) table.back().push_back(numberAndWord(cell.result.label));
    table.back().push_back(numberAndWord(labels.map.worstOf(i)));
  }
  writeTable(table, out);
}

void writeIntervals(const Labels& labels, const Request& request, std::ostream& out) {
  std::vector<std::vector<std::string>> table{
      {request.by, "measurand", "label", "share inside", "measured", "n", "simulated", "n"}};
  for (std::size_t i = 0; i < labels.cells.size(); ++i) {
    for (std::size_t k = 0; k < request.columns.size(); ++k) {
      const Cell& cell = labels.cells[i][k];
      table.push_back({labels.map.parameterSamples()[i], withUnit(request.columns[k], request.unitOf(k)),
                       std::string(wordOf(cell.result.label)), core::significant(cell.result.share_inside, 4),
                       intervalText(cell.result.measured), std::to_string(cell.n_real),
                       intervalText(cell.result.simulated), std::to_string(cell.n_sim)});
    }
  }
  writeTable(table, out);
}

void writeLabels(const Labels& labels, const Request& request, std::ostream& out) {
  const metrics::ViehofOptions& options = request.options;
  out << fmt::format(
      "Validity map (Viehof 2018): share of the simulated {:g} % tolerance interval that lies in the measured one\n"
      "  green: share >= {:g}, yellow: >= {:g}, red: > {:g}, else black (the thresholds are ours: say them with the "
      "result)\n\n",
      100.0 * options.confidence, options.green, options.yellow, options.red);
  writeMap(labels, request, out);
  out << fmt::format("\n  {}\n\nTolerance intervals behind the labels: a wide measured one excuses much\n\n",
                     countsText(labels));
  writeIntervals(labels, request, out);
}

ordered_json optionsOf(const Request& request) {
  ordered_json options{{"by", request.by}, {"repetition", nullptr}};
  if (!request.repetition.empty()) options["repetition"] = request.repetition;
  options["confidence"] = request.options.confidence;
  options["green"] = request.options.green;
  options["yellow"] = request.options.yellow;
  options["red"] = request.options.red;
  return options;
}

ordered_json jsonOf(const Cell& cell, const std::string& measurand) {
  const metrics::ViehofResult& result = cell.result;
  return {{"measurand", measurand},
          {"label", wordOf(result.label)},
          {"number", static_cast<int>(result.label)},
          {"share_inside", result.share_inside},
          {"measured", {result.measured.low, result.measured.high}},
          {"simulated", {result.simulated.low, result.simulated.high}},
          {"n_real", cell.n_real},
          {"n_sim", cell.n_sim}};
}

ordered_json documentOf(const Labels& labels, const Request& request) {
  ordered_json document = validityDocument(kMethod);
  document["real"] = request.real;
  document["simulated"] = request.simulated;
  document["options"] = optionsOf(request);
  for (std::size_t k = 0; k < request.columns.size(); ++k) {
    document["measurands"].push_back({{"name", request.columns[k]}, {"unit", request.unitOf(k)}});
  }
  for (const ValidityLabel label : kLabels) document["counts"][std::string(wordOf(label))] = labels.count(label);
  for (std::size_t i = 0; i < labels.cells.size(); ++i) {
    ordered_json sample{{"name", labels.map.parameterSamples()[i]}, {"worst", wordOf(labels.map.worstOf(i))}};
    for (std::size_t k = 0; k < request.columns.size(); ++k) {
      sample["labels"].push_back(jsonOf(labels.cells[i][k], request.columns[k]));
    }
    document["samples"].push_back(std::move(sample));
  }
  return document;
}

void mustHaveAUnitEach(const Request& request) {
  if (request.units.size() < 2 || request.units.size() == request.columns.size()) return;
  throw core::InputError({.item = "--unit"},
                         fmt::format("is given {} times for {} columns.", request.units.size(), request.columns.size()),
                         "Give one unit for all, or one for each --column in the same order.");
}

/// Detections are no repetitions: a column that usually tells repetitions apart was perhaps forgotten.
void remarkForgottenRepetition(const KeyedRows& real, const Request& request, const Session& session) {
  if (session.quiet || !request.repetition.empty()) return;
  for (const std::string& name : real.header) {
    const bool usual = name == "frame" || name == "setup" || name == "repetition" || name == "run";
    if (!usual || name == request.by) continue;
    session.messages << fmt::format(
        "fidelis: every row is taken as one repetition. If rows are detections, give --repetition {}.\n", name);
    return;
  }
}

void runLabels(const Request& request, const Session& session) {
  mustBeDistinctColumns(request.columns);
  mustHaveAUnitEach(request);
  const KeyedRows real = readKeyedRows(request.real, request.keys(), request.columns);
  const KeyedRows simulated = readKeyedRows(request.simulated, request.keys(), request.columns);
  remarkForgottenRepetition(real, request, session);
  const Labels labels = labelsOf(real, simulated, request);
  if (request.json.empty()) {
    writeLabels(labels, request, session.out);
  } else {
    session.writeJsonTo(request.json, documentOf(labels, request));
  }
}

const char* const kFooter =
    "REAL and SIM are the CSV files that 'fidelis metric' takes, with one column more that names the sample. With\n"
    "--repetition the rows of a repetition (detections of a frame, frames of a set-up) are averaged first; without it\n"
    "every row is a repetition, and detections would make a model look better than it is. The measurement needs two\n"
    "repetitions or more; a single simulated one is a model without scatter. Numbers of the labels: 1 green, 2 "
    "yellow,\n"
    "3 red, 4 black. The idea is Viehof's, the thresholds are choices of this program.\n\n"
    "Example of a file:\n"
    "  sample,frame,range_m,epw_m\n"
    "  10 m dry,0,10.02,1.52\n\n"
    "Examples:\n"
    "  fidelis validity labels real.csv sim.csv --column range_m --column epw_m --repetition frame\n"
    "  fidelis validity labels real.csv sim.csv --by angle_deg --column range_m --yellow 0.8 --json labels.json";

}  // namespace

void addLabels(CLI::App& validity, Session& session) {
  auto request = std::make_shared<Request>();
  CLI::App* command = validity.add_subcommand(
      "labels", "Viehof's labels of every sample and measurand, and the map that they make: green to black");
  command->add_option("REAL", request->real, "What was measured: a CSV file; gzip is understood")->required();
  command->add_option("SIM", request->simulated, "What was simulated, with the same columns")->required();
  command->add_option("--column", request->columns, "Measurand, by its name in the header; may be repeated")
      ->required()
      ->allow_extra_args(false);
  command
      ->add_option("--unit", request->units,
                   "Unit, one for all or one for each --column; without it told by the name's suffix (_m, _rad, …)")
      ->allow_extra_args(false);
  command->add_option("--by", request->by, "Column that names the sample of each row")->capture_default_str();
  command->add_option("--repetition", request->repetition, "Column that numbers the repetitions within a sample");
  command->add_option("--confidence", request->options.confidence, "Of the tolerance intervals")->capture_default_str();
  command->add_option("--green", request->options.green, "Least share of the simulated interval inside the measured")
      ->capture_default_str();
  command->add_option("--yellow", request->options.yellow, "Least share for yellow")->capture_default_str();
  command->add_option("--red", request->options.red, "More than this share for red, else black")->capture_default_str();
  command->add_option("--json", request->json, "Write the result as JSON to this file (-: standard output)");
  command->footer(kFooter);
  command->callback([request, &session] { runLabels(*request, session); });
}

}  // namespace app
