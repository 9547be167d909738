#include <CLI/CLI.hpp>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <ostream>

#include "app/cli/metric/request.h"
#include "app/cli/validity/curves.h"
#include "app/cli/validity/output.h"
#include "app/cli/validity/validity.h"
#include "core/error.h"
#include "core/text.h"
#include "metrics/validity/tolerance_check.h"

namespace app {

using nlohmann::ordered_json;

namespace {

constexpr Method kMethod{
    .kind = "tolerance",
    .title = "Share of points inside a tolerance band",
    .source = "in the style of ISO 19364:2016 and ISO 19365:2016; tolerances are inputs, not the standards'"};

struct Request {
  std::string real;
  std::string simulated;
  CurveColumns columns;
  std::string unit;
  std::string around;
  metrics::Tolerance tolerance;
  std::string json;

  /// ISO 19364 draws the band around the simulation; deviations are those of repeated measurements.
  [[nodiscard]] bool isAroundMeasured() const {
    return around.empty() ? tolerance.deviations > 0.0 : around == "measured";
  }
  [[nodiscard]] std::string unitOfValue() const { return unit.empty() ? unitOfName(columns.value) : unit; }
};

/// A point that is outside, with all that a reader needs to find it.
struct Outside {
  const Curve* curve;
  std::size_t index;
  double excess;
};

struct CheckedCurve {
  const Curve* curve;
  metrics::ToleranceCheck check;
};

struct Checked {
  const Curves* centre;   ///< the band is around these
  const Curves* checked;  ///< and these should be inside
  metrics::ToleranceBand band;
  std::vector<CheckedCurve> curves;
  std::size_t points = 0;
  std::size_t inside = 0;
  std::optional<Outside> first;
  std::optional<Outside> worst;

  [[nodiscard]] double shareInside() const { return static_cast<double>(inside) / static_cast<double>(points); }
};

Checked check(const CurvePair& curves, const Request& request) {
  const bool around_measured = request.isAroundMeasured();
  Checked result;
  result.centre = around_measured ? &curves.real : &curves.simulated;
  result.checked = around_measured ? &curves.simulated : &curves.real;
  result.band = metrics::toleranceBand(result.centre->parameter(), result.centre->values(), request.tolerance);
  for (const Curve& curve : result.checked->curves) {
    const metrics::ToleranceCheck one = metrics::checkTolerance(result.band, curve.values);
    const std::size_t n = curve.values.size();
    result.points += n;
    result.inside += static_cast<std::size_t>(std::llround(one.share_inside * static_cast<double>(n)));
    if (one.first && !result.first) result.first = {&curve, one.first->index, one.first->excess};
    if (one.worst && (!result.worst || std::abs(one.worst->excess) > std::abs(result.worst->excess))) {
      result.worst = {&curve, one.worst->index, one.worst->excess};
    }
    result.curves.push_back({&curve, one});
  }
  return result;
}

std::string toleranceText(const Request& request) {
  std::vector<std::string> parts;
  if (request.tolerance.deviations > 0.0) {
    parts.push_back(fmt::format("{:g} standard deviations of the repetitions", request.tolerance.deviations));
  }
  if (request.tolerance.relative > 0.0) {
    parts.push_back(fmt::format("{} % of its magnitude", core::significant(100.0 * request.tolerance.relative)));
  }
  if (request.tolerance.absolute > 0.0) {
    parts.push_back(core::shortestNumber(request.tolerance.absolute) + unitBehind(request.unitOfValue()));
  }
  return core::join(parts, " + ");
}

std::string centreText(const Checked& result, const Request& request) {
  const std::size_t n = result.centre->curves.size();
  const std::string side = request.isAroundMeasured() ? "measured" : "simulated";
  return n == 1 ? "the " + side + " curve" : fmt::format("the mean of {} {} curves", n, side);
}

/// "first: real.csv:14: at time_s = 1.2 range_m is 13.1 m, 0.08 m above the bound 13.02 m"
std::string outsideText(const Outside& outside, const Checked& result, const Request& request) {
  const std::string unit = unitBehind(request.unitOfValue());
  const bool above = outside.excess > 0.0;
  return fmt::format("{}:{}: {}at {} = {} {} is {}{}, {}{} {} the bound {}{}", result.checked->file,
                     outside.curve->lines[outside.index],
                     outside.curve->name.empty() ? "" : "repetition '" + outside.curve->name + "', ",
                     request.columns.over, core::shortestNumber(outside.curve->parameter[outside.index]),
                     request.columns.value, core::significant(outside.curve->values[outside.index], 6), unit,
                     core::significant(std::abs(outside.excess), 4), unit, above ? "above" : "below",
                     core::significant((above ? result.band.high : result.band.low)[outside.index], 6), unit);
}

void writeCurves(const Checked& result, std::ostream& out) {
  std::vector<std::vector<std::string>> table{{"repetition", "n", "share inside", "worst excess"}};
  for (const CheckedCurve& one : result.curves) {
    table.push_back({one.curve->name, std::to_string(one.curve->values.size()),
                     core::significant(one.check.share_inside, 4),
                     one.check.worst ? core::significant(one.check.worst->excess, 4) : "-"});
  }
  writeTable(table, out);
}

void writeCheck(const Checked& result, const Request& request, std::ostream& out) {
  out << fmt::format("{}  {} of {} over {}: {} of {} points are in the band ({} %)\n",
                     result.first ? "OUTSIDE" : "INSIDE", request.columns.value,
                     request.isAroundMeasured() ? request.simulated : request.real, request.columns.over, result.inside,
                     result.points, core::significant(100.0 * result.shareInside(), 4));
  out << fmt::format("  band:  {} +- ({})\n", centreText(result, request), toleranceText(request));
  if (result.first) out << "  first: " << outsideText(*result.first, result, request) << "\n";
  if (result.worst) out << "  worst: " << outsideText(*result.worst, result, request) << "\n";
  if (result.curves.size() < 2) return;
  out << "\n";
  writeCurves(result, out);
}

ordered_json jsonOf(const std::optional<Outside>& outside, const Checked& result) {
  if (!outside) return nullptr;
  ordered_json point{{"file", result.checked->file}, {"line", outside->curve->lines[outside->index]}};
  if (!outside->curve->name.empty()) point["repetition"] = outside->curve->name;
  point["over"] = outside->curve->parameter[outside->index];
  point["value"] = outside->curve->values[outside->index];
  point["low"] = result.band.low[outside->index];
  point["high"] = result.band.high[outside->index];
  point["excess"] = outside->excess;
  return point;
}

ordered_json documentOf(const Checked& result, const Request& request) {
  ordered_json document = validityDocument(kMethod);
  document["real"] = request.real;
  document["simulated"] = request.simulated;
  document["options"] = {{"over", request.columns.over},
                         {"repetition", nullptr},
                         {"around", request.isAroundMeasured() ? "measured" : "simulated"},
                         {"relative", request.tolerance.relative},
                         {"absolute", request.tolerance.absolute},
                         {"band", request.tolerance.deviations}};
  if (!request.columns.repetition.empty()) document["options"]["repetition"] = request.columns.repetition;
  document["measurand"] = {{"name", request.columns.value}, {"unit", request.unitOfValue()}};
  document["passed"] = !result.first;
  document["n"] = result.points;
  document["inside"] = result.inside;
  document["share_inside"] = result.shareInside();
  document["first"] = jsonOf(result.first, result);
  document["worst"] = jsonOf(result.worst, result);
  document["centre_curves"] = result.centre->curves.size();
  for (const CheckedCurve& one : result.curves) {
    document["curves"].push_back(
        {{"name", one.curve->name}, {"n", one.curve->values.size()}, {"share_inside", one.check.share_inside}});
  }
  return document;
}

void mustTolerateSomething(const metrics::Tolerance& tolerance) {
  if (tolerance.deviations > 0.0 || tolerance.absolute > 0.0 || tolerance.relative > 0.0) return;
  throw core::InputError({.item = "--relative, --absolute, --band"}, "are all 0; the band has no width.",
                         "Give one at least, such as --relative 0.1 for 10 %.");
}

void mustHaveDeviations(const CurvePair& curves, const Request& request) {
  const Curves& centre = request.isAroundMeasured() ? curves.real : curves.simulated;
  if (request.tolerance.deviations == 0.0 || centre.curves.size() > 1) return;
  throw core::InputError({.file = centre.file}, "holds a single curve; --band needs the deviation of repeated ones.",
                         request.columns.repetition.empty()
                             ? "Name the column that tells the repetitions apart with --repetition."
                             : "Put the repetitions into one file, told apart by '" + request.columns.repetition +
                                   "', or use --relative and --absolute.");
}

void runToleranceCheck(const Request& request, Session& session) {
  mustTolerateSomething(request.tolerance);
  const CurvePair curves = readCurves(request.real, request.simulated, request.columns);
  mustHaveDeviations(curves, request);
  const Checked result = check(curves, request);
  if (request.json.empty()) {
    writeCheck(result, request, session.out);
  } else {
    session.writeJsonTo(request.json, documentOf(result, request));
  }
  session.status = result.first ? kNotAccepted : kAllGood;
}

const char* const kFooter =
    "The band is k s + absolute + relative |centre| to either side: k the --band, s the standard deviation of "
    "repeated\n"
    "curves. As ISO 19364 draws it, it lies around the simulation and the measurement must be inside; with --band it\n"
    "lies around the mean of the repeated measurements and the simulation must be inside; --around decides otherwise.\n"
    "Both files need the same values of --over, in any order. A file without the column --repetition holds one curve.\n"
    "Which tolerance is right is the requirement's affair: there is no default.\n"
    "Exit status: 0 all points inside, 1 one or more outside, 2 bad usage or input.\n\n"
    "Examples:\n"
    "  fidelis validity tolerance real.csv sim.csv --over time_s --column range_m --relative 0.1 --absolute 0.02\n"
    "  fidelis validity tolerance runs.csv sim.csv --over time_s --column range_m --repetition run --band 2\n"
    "  fidelis validity tolerance real.csv sim.csv --over range_m --column epw_m --absolute 0.1 --around measured";

}  // namespace

void addToleranceCheck(CLI::App& validity, Session& session) {
  auto request = std::make_shared<Request>();
  CLI::App* command = validity.add_subcommand(
      "tolerance", "Tolerance check in the style of ISO 19364: does one curve stay in a band around the other?");
  command->add_option("REAL", request->real, "What was measured: a CSV file; gzip is understood")->required();
  command->add_option("SIM", request->simulated, "What was simulated, with the same columns")->required();
  command->add_option("--over", request->columns.over, "Column of the parameter: time, range, angle")->required();
  command->add_option("--column", request->columns.value, "Column of the measurand")->required();
  command->add_option("--unit", request->unit, "Its unit; without it told by the name's suffix (_m, _rad, …)");
  command->add_option("--relative", request->tolerance.relative, "Share of the centre's magnitude: 0.1 for 10 %")
      ->check(CLI::NonNegativeNumber);
  command->add_option("--absolute", request->tolerance.absolute, "In the unit of the measurand")
      ->check(CLI::NonNegativeNumber);
  command->add_option("--band", request->tolerance.deviations, "Times the standard deviation of repeated curves")
      ->check(CLI::NonNegativeNumber);
  command->add_option("--repetition", request->columns.repetition, "Column that tells repeated curves apart");
  command->add_option("--around", request->around, "Where the band lies (default: simulated; with --band: measured)")
      ->check(CLI::IsMember({"simulated", "measured"}));
  command->add_option("--json", request->json, "Write the result as JSON to this file (-: standard output)");
  command->footer(kFooter);
  command->callback([request, &session] { runToleranceCheck(*request, session); });
}

}  // namespace app
