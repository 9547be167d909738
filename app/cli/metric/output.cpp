#include "app/cli/metric/output.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <ostream>

#include "core/text.h"
#include "core/version.h"

namespace app {

using nlohmann::ordered_json;

namespace {

std::string unitText(metrics::MetricUnit unit, const std::string& measurand) {
  switch (unit) {
    case metrics::MetricUnit::Measurand:
      return measurand;
    case metrics::MetricUnit::Square:
      return measurand.empty() ? "" : measurand + "^2";
    case metrics::MetricUnit::Cells:
      return "cells";
    case metrics::MetricUnit::Bit:
      return "bit";
    case metrics::MetricUnit::None:
      break;
  }
  return "";
}

ordered_json jsonOf(const MetricResult& result) {
  if (result.shape == metrics::MetricShape::Number) return result.numbers.front();
  if (result.shape == metrics::MetricShape::List) return result.numbers;
  ordered_json object = ordered_json::object();
  for (std::size_t i = 0; i < result.numbers.size(); ++i) object[std::string(result.parts[i])] = result.numbers[i];
  return object;
}

ordered_json jsonOf(const metrics::ConfidenceInterval& interval) {
  return {{"low", interval.low},
          {"high", interval.high},
          {"standard_error", interval.standard_error},
          {"bias", interval.bias}};
}

ordered_json intervalsOf(const MeasurandResult& measurand) {
  ordered_json intervals = ordered_json::object();
  for (const MetricResult& result : measurand.results) {
    const std::string name(result.info.name);
    for (std::size_t i = 0; i < result.intervals.size(); ++i) {
      if (result.parts.empty()) {
        intervals[name] = jsonOf(result.intervals[i]);
      } else {
        intervals[name][std::string(result.parts[i])] = jsonOf(result.intervals[i]);
      }
    }
  }
  return intervals;
}

ordered_json jsonOf(const metrics::Interval& interval) { return {interval.low, interval.high}; }

void addLookUpsTo(ordered_json& entry, const MeasurandResult& measurand) {
  for (const LookUp& look_up : measurand.look_ups) {
    entry[look_up.at_level ? "quantiles" : "probabilities"].push_back(
        {{look_up.at_level ? "level" : "value", look_up.at},
         {"real", jsonOf(look_up.measured)},
         {"simulated", jsonOf(look_up.simulated)}});
  }
}

/// What chance does to the results, as far as it was asked for.
void addChanceTo(ordered_json& entry, const MeasurandResult& measurand) {
  const ordered_json intervals = intervalsOf(measurand);
  if (!intervals.empty()) entry["intervals"] = intervals;
  for (const FloorResult& floor : measurand.floors) {
    ordered_json& line = entry["floor"][std::string(floor.name)];
    line = {
        {"perfect_model_median", nullptr}, {"median", floor.median}, {"quantile_95", floor.high}, {"p_value", nullptr}};
    if (floor.perfect_median) line["perfect_model_median"] = *floor.perfect_median;
    if (floor.p_value) line["p_value"] = *floor.p_value;
  }
  for (const RepetitionResult& needed : measurand.repetitions) {
    entry["repetitions"][std::string(needed.name)] = {{"half_width", needed.half_width},
                                                      {"factor", needed.factor},
                                                      {"interval", {needed.low, needed.high}},
                                                      {"measured_share", needed.measured_share}};
  }
}

ordered_json boxOptionsOf(const MetricRequest& request) {
  ordered_json options{{"combine", request.combine}, {"weights", request.weights}};
  if (!request.shares.empty()) options["shares"] = request.shares;
  options["sim_margin"] = request.simulated_margin;
  options["real_margin"] = request.measured_margin;
  if (request.band) options["band"] = *request.band;
  return options;
}

ordered_json chanceOptionsOf(const MetricRequest& request) {
  return {{"intervals", request.intervals},
          {"unit", request.chance_unit},
          {"block", request.block},
          {"paired", request.paired},
          {"bca", request.bca},
          {"confidence", request.confidence},
          {"seed", request.seed}};
}

ordered_json optionsOf(const MetricRequest& request) {
  ordered_json options{{"data", request.data}, {"shift", request.shift}, {"experiments", nullptr}};
  if (request.experiments) options["experiments"] = *request.experiments;
  if (!request.settings.empty()) options["set"] = request.settings;
  if (request.shapesBoxes()) options["boxes"] = boxOptionsOf(request);
  if (request.asksForChance()) options["chance"] = chanceOptionsOf(request);
  return options;
}

std::string numberForReader(double value) { return std::isnan(value) ? "-" : core::significant(value, 6); }

std::string valueForReader(const std::vector<double>& numbers) {
  if (numbers.size() == 1) return numberForReader(numbers.front());
  std::vector<std::string> parts;
  for (const double value : numbers) parts.push_back(numberForReader(value));
  return "[" + core::join(parts) + "]";
}

/// "[1, 2]", one for each number of the metric.
std::string intervalText(const MetricResult& result) {
  std::string text;
  for (const metrics::ConfidenceInterval& interval : result.intervals) {
    text += fmt::format("{}[{}, {}]", text.empty() ? "" : " ", core::significant(interval.low, 4),
                        core::significant(interval.high, 4));
  }
  return text;
}

/// Heading of the column of intervals; "" if there are none.
std::string intervalTitle(const MeasurandResult& measurand) {
  for (const MetricResult& result : measurand.results) {
    if (!result.intervals.empty()) return fmt::format("{:g} % interval", 100.0 * result.intervals.front().confidence);
  }
  return "";
}

std::string intervalText(const metrics::Interval& interval) {
  if (interval.low == interval.high) return numberForReader(interval.low);
  return fmt::format("[{}, {}]", numberForReader(interval.low), numberForReader(interval.high));
}

void writeLookUps(const MeasurandResult& measurand, std::ostream& out) {
  for (const LookUp& look_up : measurand.look_ups) {
    out << fmt::format("  {} {:g}: measured {}, simulated {}\n",
                       look_up.at_level ? "quantile at level" : "share of values up to", look_up.at,
                       intervalText(look_up.measured), intervalText(look_up.simulated));
  }
}

/// Floors and repetitions, below the metrics.
void writeChance(const MeasurandResult& measurand, std::ostream& out) {
  for (const FloorResult& floor : measurand.floors) {
    const std::string perfect = floor.perfect_median ? fmt::format("a perfect model gives {} (median); ",
                                                                   numberForReader(*floor.perfect_median))
                                                     : "";
    out << fmt::format("  floor of {}: {}both sides dealt out anew {} (median), {} (95 %){}\n", floor.name, perfect,
                       numberForReader(floor.median), numberForReader(floor.high),
                       floor.p_value ? fmt::format("; p = {}", core::significant(*floor.p_value, 2)) : "");
  }
  for (const RepetitionResult& needed : measurand.repetitions) {
    out << fmt::format("  {} to +-{}: {} times these data [{}, {}]", needed.name, needed.half_width,
                       core::significant(needed.factor, 2), core::significant(needed.low, 2),
                       core::significant(needed.high, 2));
    if (!std::isnan(needed.measured_share)) {
      out << fmt::format("; {:.0f} % of the variance is the measurement's", 100.0 * needed.measured_share);
    }
    out << "\n";
  }
}

/// One line a reason.
std::string leftOutText(const MeasurandResult& measurand) {
  std::vector<std::pair<std::string, std::vector<std::string>>> by_reason;
  for (const LeftOut& metric : measurand.left_out) {
    auto found = std::find_if(by_reason.begin(), by_reason.end(), [&](auto& r) { return r.first == metric.reason; });
    if (found == by_reason.end()) found = by_reason.insert(by_reason.end(), {metric.reason, {}});
    found->second.emplace_back(metric.name);
  }
  std::string text;
  for (const auto& [reason, names] : by_reason) {
    text += fmt::format("  left out: {}: {}\n", core::join(names), reason);
  }
  return text;
}

std::string kindsOf(const metrics::MetricInfo& info) {
  std::vector<std::string> kinds;
  for (const metrics::DataKind kind : info.data) kinds.emplace_back(metrics::toString(kind));
  return core::join(kinds);
}

std::string listUnit(metrics::MetricUnit unit) {
  const std::string text = unitText(unit, "measurand");
  return text.empty() ? "-" : text;
}

/// A bar would end the cell.
std::string cell(std::string_view text) {
  std::string escaped;
  for (const char letter : text) escaped += letter == '|' ? std::string("\\|") : std::string(1, letter);
  return escaped.empty() ? "-" : escaped;
}

}  // namespace

ordered_json metricDocument(std::span<const MeasurandResult> measurands, const MetricRequest& request) {
  ordered_json document{{"format", "fidelis-metric"}, {"version", 1}, {"fidelis_version", core::kVersion}};
  document["real"] = request.real;
  document["simulated"] = request.simulated;
  document["options"] = optionsOf(request);
  document["measurands"] = ordered_json::array();
  for (const MeasurandResult& measurand : measurands) {
    ordered_json entry{{"name", measurand.name}, {"unit", measurand.unit}, {"n_real", measurand.n_real}};
    entry["n_sim"] = measurand.n_sim;
    entry["scale"] = metrics::toString(measurand.scale);
    for (const MetricResult& result : measurand.results) entry[std::string(result.info.name)] = jsonOf(result);
    addLookUpsTo(entry, measurand);
    addChanceTo(entry, measurand);
    for (const LeftOut& metric : measurand.left_out) entry["left_out"][std::string(metric.name)] = metric.reason;
    document["measurands"].push_back(std::move(entry));
  }
  return document;
}

void writeMetricTable(std::span<const MeasurandResult> measurands, std::ostream& out) {
  for (const MeasurandResult& measurand : measurands) {
    std::vector<std::string> sizes;
    for (const std::size_t n : measurand.n_sim) sizes.push_back(std::to_string(n));
    out << fmt::format("{}: n = {} measured, {} simulated{}\n", measurand.name, measurand.n_real,
                       core::join(sizes, " + "), sizes.size() > 1 ? " (p-box)" : "");
    std::size_t width = 18;
    for (const MetricResult& result : measurand.results) width = std::max(width, result.info.name.size());
    const std::string title = intervalTitle(measurand);
    const std::size_t interval_width = title.empty() ? 0 : 26;
    out << fmt::format("  {:<{}} {:>24}  {:<{}}{:<5} {}\n", "metric", width, "value", title, interval_width, "unit",
                       "meaning");
    for (const MetricResult& result : measurand.results) {
      const std::string unit = unitText(result.info.unit, measurand.unit);
      const bool many = result.numbers.size() > 2;  // then a line each, below
      out << fmt::format("  {:<{}} {:>24}  {:<{}}{:<5} {}\n", result.info.name, width,
                         many ? "" : valueForReader(result.numbers), many ? "" : intervalText(result), interval_width,
                         unit.empty() ? "-" : unit, result.info.meaning);
      for (std::size_t i = 0; many && i < result.numbers.size(); ++i) {
        out << fmt::format("    {:<{}} {:>24}\n", result.parts[i], width - 2, numberForReader(result.numbers[i]));
      }
    }
    writeLookUps(measurand, out);
    writeChance(measurand, out);
    out << leftOutText(measurand);
  }
}

std::string metricListAsMarkdown() {
  std::string text =
      "| No. | name | metric | formula | best … worst | unit | scale | data | p-box | criteria | source |\n"
      "|-|-|-|-|-|-|-|-|-|-|-|\n";
  for (const metrics::MetricInfo& info : metrics::allMetricInfos()) {
    text += fmt::format("| {} | `{}` | {}: {} | {} | {} … {} | {} | {} | {} | {} | {} | {} |\n",
                        info.number == 0 ? "-" : std::to_string(info.number), info.name, cell(info.title),
                        cell(info.meaning), cell(info.formula), cell(info.best), cell(info.worst), listUnit(info.unit),
                        metrics::toString(info.scale), kindsOf(info), info.p_box ? "yes" : "no", cell(info.meets),
                        cell(info.source));
  }
  return text;
}

ordered_json metricListAsJson() {
  ordered_json list = ordered_json::array();
  for (const metrics::MetricInfo& info : metrics::allMetricInfos()) {
    ordered_json entry{{"name", info.name}, {"title", info.title}, {"meaning", info.meaning}};
    entry["number"] = info.number == 0 ? ordered_json(nullptr) : ordered_json(info.number);
    entry["formula"] = info.formula;
    entry["best"] = info.best;
    entry["worst"] = info.worst;
    entry["unit"] = listUnit(info.unit);
    entry["scale"] = metrics::toString(info.scale);
    entry["data"] = ordered_json::array();
    for (const metrics::DataKind kind : info.data) entry["data"].push_back(metrics::toString(kind));
    entry["p_box"] = info.p_box;
    entry["criteria"] = info.meets;
    entry["source"] = info.source;
    list.push_back(std::move(entry));
  }
  return {{"format", "fidelis-metric-list"}, {"version", 1}, {"fidelis_version", core::kVersion}, {"metrics", list}};
}

}  // namespace app
