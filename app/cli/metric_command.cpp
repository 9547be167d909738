#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <ostream>
#include <set>

#include "app/cli/commands.h"
#include "app/cli/metric/compare.h"
#include "app/cli/metric/output.h"
#include "core/error.h"
#include "core/text.h"

namespace app {

namespace {

struct Kind {
  metrics::DataKind kind;
  std::string_view files;  ///< what the files hold
  std::vector<MeasurandResult> (*compare)(const MetricRequest& request, const Session& session);
};

/// The list: one line a kind of data.
constexpr std::array<Kind, 7> kKinds{{
    {metrics::DataKind::Values, "a column of each file, in any order; several SIM files make a p-box", compareValues},
    {metrics::DataKind::Series, "a column of each file, row by row in step", compareSeries},
    {metrics::DataKind::PointCloud, "columns x_m y_m z_m, or range_m azimuth_rad elevation_rad", comparePointClouds},
    {metrics::DataKind::RangeImage, "a measurement with layer azimuth_rad range_m, or a bare matrix of ranges in m",
     compareRangeImages},
    {metrics::DataKind::OccupancyGrid, "a bare matrix of occupancy probabilities", compareOccupancyGrids},
    {metrics::DataKind::ObjectList, "objects at one time: id x_m y_m [z_m length_m width_m height_m yaw_rad]",
     compareObjectLists},
    {metrics::DataKind::Tracks, "the same with a column frame", compareTracks},
}};

const Kind& kindOf(const std::string& data) {
  return *std::find_if(kKinds.begin(), kKinds.end(), [&](const Kind& k) { return metrics::toString(k.kind) == data; });
}

std::vector<std::string> kindNames() {
  std::vector<std::string> names;
  for (const Kind& kind : kKinds) names.emplace_back(metrics::toString(kind.kind));
  return names;
}

void runMetric(const MetricRequest& request, const Session& session) {
  if (request.list) {
    if (request.json.empty()) {
      session.out << metricListAsMarkdown();
    } else {
      session.writeJsonTo(request.json, metricListAsJson());
    }
    return;
  }
  if (request.real.empty() || request.simulated.empty()) {
    throw core::InputError({.item = request.real.empty() ? "REAL" : "SIM"}, "is required.",
                           "Give a measured file and one simulated or more; fidelis metric --help shows examples.");
  }
  if ((request.shapesBoxes() || !request.at_levels.empty() || !request.at_values.empty()) && request.data != "values") {
    throw core::InputError({.item = "--data " + request.data}, "has no distributions to combine, widen or look up.",
                           "These options are for --data values.");
  }
  if (request.asksForChance() && request.data != "values") {
    throw core::InputError({.item = "--intervals, --floor, --half-width"}, "are for --data values only.",
                           "Compare a column of values, or leave them out.");
  }
  const std::vector<MeasurandResult> measurands = kindOf(request.data).compare(request, session);
  if (request.json.empty()) {
    writeMetricTable(measurands, session.out);
  } else {
    session.writeJsonTo(request.json, metricDocument(measurands, request));
  }
}

std::string footer() {
  std::string text =
      "Several SIM files are runs with different epistemic assumptions: their envelope is a p-box. Metrics that know "
      "no\n"
      "p-box take all simulated values pooled. A positive d_bias means that the simulation is too high.\n\n"
      "Kinds of data (--data) and what the files hold:\n";
  for (const Kind& kind : kKinds) text += fmt::format("  {:<15} {}\n", metrics::toString(kind.kind), kind.files);
  text += "\nMetrics of values (fidelis metric --list shows those of all kinds, with formula and source):\n";
  for (const metrics::Metric& metric : metrics::metricCatalog()) {
    text += fmt::format("  {:<24} {}\n", metric.info.name, metric.info.meaning);
  }
  return text +
         "\nExamples:\n"
         "  fidelis metric real.csv sim.csv --column range_m\n"
         "  fidelis metric real.csv.gz corner-*.csv --column range_m --column epw_m --json result.json\n"
         "  fidelis metric real.csv sim.csv --column Distance --unit m --metric d_bias,d_cavm --json -\n"
         "  fidelis metric real.csv sim.csv --column range_m --intervals 1000 --chance-unit frame --floor\n"
         "  fidelis metric real.csv sim.csv --data point-cloud --metric hausdorff\n"
         "  fidelis metric truth.csv objects.csv --data object-list --set cut_off_m=2";
}

void addFiles(CLI::App& command, MetricRequest& request) {
  command.add_option("REAL", request.real, "What was measured: a CSV file; gzip is understood");
  command.add_option("SIM", request.simulated, "What was simulated: one CSV file, or several that make a p-box");
  command.add_option("--data", request.data, "What the files hold; see the list below")
      ->check(CLI::IsMember(kindNames()))
      ->capture_default_str();
  command.add_option("--column", request.columns, "Column to compare, by its name in the header; may be repeated")
      ->allow_extra_args(false);
  command
      .add_option("--unit", request.units,
                  "Unit, one for all or one for each --column; without it told by the name's suffix (_m, _rad, …)")
      ->allow_extra_args(false);
  command
      .add_option("--scale", request.scales,
                  "Scale of measurement: nominal, ordinal, interval or ratio, or COLUMN=SCALE; may be repeated. "
                  "Metrics that ask for more are refused")
      ->allow_extra_args(false);
}

void addChoices(CLI::App& command, MetricRequest& request) {
  command.add_option("--metric", request.metrics, "Only these metrics, in this order; may be repeated or a,b,c")
      ->delimiter(',')
      ->allow_extra_args(false);
  command.add_option("--set", request.settings, "Setting of the metrics of this kind of data, NAME=NUMBER; repeatable")
      ->allow_extra_args(false);
  command
      .add_option("--shift", request.shift, "How dvm removes the bias: one shift, as published, or the balanced one")
      ->check(CLI::IsMember({"one", "balanced"}))
      ->capture_default_str();
  command
      .add_option("--experiments", request.experiments,
                  "Replications of the experiment, for the safety factor of d_mavm; without it n of REAL")
      ->check(CLI::PositiveNumber);
  command.add_flag("--list", request.list,
                   "List every metric with number in the literature, formula, range and source");
  command.add_option("--json", request.json, "Write the results as JSON to this file (-: standard output)");
}

void addBoxOptions(CLI::App& command, MetricRequest& request) {
  command
      .add_option(
          "--combine", request.combine,
          "How several SIM files make one box: envelope (each file one epistemic choice, E-outer), a-outer (row "
          "i of every file is the same aleatory sample) or mixture (shares are known)")
      ->check(CLI::IsMember({"envelope", "a-outer", "mixture"}))
      ->capture_default_str();
  command.add_option("--shares", request.shares, "Shares of the SIM files in a mixture, a,b,c; without it all alike")
      ->delimiter(',')
      ->allow_extra_args(false);
  command.add_option("--weights", request.weights, "Column with the weight of each row, in every file");
  command
      .add_option("--sim-margin", request.simulated_margin,
                  "What every simulated value may be off: its box is widened by +- this")
      ->check(CLI::NonNegativeNumber);
  command
      .add_option("--real-margin", request.measured_margin,
                  "What every measured value may be off: the measurement becomes a box, too")
      ->check(CLI::NonNegativeNumber);
  command
      .add_option("--band", request.band,
                  "Take for the measurement all distributions that it is consistent with at this risk, such as 0.05 "
                  "(Dvoretzky-Kiefer-Wolfowitz)")
      ->check(CLI::Range(1e-9, 0.999));
  command
      .add_option("--at-level", request.at_levels, "Tell the quantiles of both sides at this probability; repeatable")
      ->check(CLI::Range(0.0, 1.0))
      ->allow_extra_args(false);
  command.add_option("--at-value", request.at_values, "Tell the share of both sides up to this value; repeatable")
      ->allow_extra_args(false);
}

void addChanceOptions(CLI::App& command, MetricRequest& request) {
  command
      .add_option("--intervals", request.intervals,
                  "Bootstrap intervals of the metrics of values, with this many replicates (1000 is usual)")
      ->check(CLI::PositiveNumber);
  command.add_option("--chance-unit", request.chance_unit,
                     "Column with the frame or set-up of each value: whole units are drawn. Without it values are, "
                     "which gives far too narrow intervals where detections share errors");
  command.add_option("--block", request.block, "Neighbouring units drawn together, where they depend on each other")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command.add_flag("--paired", request.paired, "The same units were measured and simulated: draw them together");
  command.add_flag("--bca", request.bca, "Bias-corrected and accelerated intervals in place of percentiles");
  command.add_option("--confidence", request.confidence, "Of the intervals")
      ->check(CLI::Range(0.5, 0.9999))
      ->capture_default_str();
  command.add_flag(
      "--floor", request.floor,
      "What d_avm and d_cavm of a perfect model are at these numbers of values (no model keeps a limit "
      "below), and with both sides dealt out anew: their p-values, and the width that chance gives a p-box");
  command
      .add_option("--half-width", request.half_widths,
                  "METRIC=WIDTH: how many times the data are needed for an interval of +-WIDTH; may be repeated")
      ->allow_extra_args(false);
}

}  // namespace

void mustHaveColumns(const MetricRequest& request) {
  if (request.columns.empty()) {
    throw core::InputError({.item = "--column"}, "is required.", "Name the column to compare, as in the header line.");
  }
  std::set<std::string> seen;
  for (const std::string& column : request.columns) {
    if (!seen.insert(column).second) {
      throw core::InputError({.item = "--column " + column}, "is given twice.", "Give every column once.");
    }
  }
  if (request.units.size() > 1 && request.units.size() != request.columns.size()) {
    throw core::InputError(
        {.item = "--unit"},
        fmt::format("is given {} times for {} columns.", request.units.size(), request.columns.size()),
        "Give one unit for all, or one for each --column in the same order.");
  }
  for (const std::string& scale : request.scales) {
    const std::string column = scale.substr(0, std::min(scale.find('='), scale.size()));
    if (column.size() < scale.size() && !seen.contains(column)) {
      throw core::InputError({.item = "--scale " + scale}, "names no --column.",
                             "The columns are " + core::join(request.columns) + ".");
    }
  }
}

void mustHaveNoColumns(const MetricRequest& request) {
  const bool column = !request.columns.empty();
  if (!column && request.scales.empty() && request.units.empty()) return;
  throw core::InputError({.item = column                  ? "--column"
                                  : request.units.empty() ? "--scale"
                                                          : "--unit"},
                         "is not for --data " + request.data + ".",
                         "These files have fixed columns; fidelis metric --help lists them.");
}

void mustHaveOneSimulation(const MetricRequest& request) {
  if (request.simulated.size() == 1) return;
  throw core::InputError({.file = request.simulated[1]}, "is one file too many for --data " + request.data + ".",
                         "Only values make a p-box of several SIM files; compare them one by one.");
}

std::optional<core::InputError> scaleError(const metrics::MetricInfo& info, const MeasurandResult& measurand) {
  if (metrics::isMeaningful(info, measurand.scale)) return std::nullopt;
  return core::InputError(
      {.item = "metric '" + std::string(info.name) + "'"},
      fmt::format("needs an {} scale, and {} is {}.", metrics::toString(info.scale), measurand.name,
                  metrics::toString(measurand.scale)),
      "Differences of ranks or names mean nothing. Use a metric of ranks, such as ks, or correct --scale.");
}

void throwUnknownMetric(const std::string& name, const std::string& data, const std::vector<std::string>& known) {
  for (const metrics::MetricInfo& info : metrics::allMetricInfos()) {
    if (info.name != name || info.data.empty()) continue;
    throw core::InputError({.item = "metric '" + name + "'"}, "is none of " + data + ".",
                           "Give --data " + std::string(metrics::toString(info.data.front())) + ".");
  }
  const std::string nearest = core::nearestName(name, known);
  throw core::InputError(
      {.item = "metric '" + name + "'"}, "is not known.",
      nearest.empty() ? "The metrics are " + core::join(known) + "." : "Did you mean '" + nearest + "'?");
}

void addMetricCommand(CLI::App& program, Session& session) {
  auto request = std::make_shared<MetricRequest>();
  CLI::App* command = program.add_subcommand("metric", "Compare measured and simulated data: how far apart are they?");
  addFiles(*command, *request);
  addChoices(*command, *request);
  addBoxOptions(*command->add_option_group("Boxes"), *request);
  addChanceOptions(*command->add_option_group("Chance"), *request);
  command->footer(footer());
  command->callback([request, &session] {
    request->seed = session.seed.value_or(request->seed);
    runMetric(*request, session);
  });
}

}  // namespace app
