#include "app/cli/predict/request.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/csv.h"
#include "core/error.h"
#include "core/text.h"

namespace app {

namespace {

/// "range_m=12.4,angle_deg=30", every parameter once, in any order.
std::vector<double> pointOf(const std::string& words, const std::vector<std::string>& parameters) {
  std::vector<double> point(parameters.size(), std::nan(""));
  const core::Place place{.item = "--at " + words};
  std::string_view rest = words;
  while (!rest.empty()) {
    const std::string_view part = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(rest.size(), part.size() + 1));
    const std::size_t equals = part.find('=');
    const std::string name = core::trimmed(part.substr(0, equals));
    const auto found = std::find(parameters.begin(), parameters.end(), name);
    if (found == parameters.end()) {
      const std::string nearest = core::nearestName(name, parameters);
      throw core::InputError(
          place, "'" + name + "' is no parameter of this prediction.",
          nearest.empty() ? "It is over " + core::join(parameters) + "." : "Did you mean '" + nearest + "'?");
    }
    double& value = point[static_cast<std::size_t>(found - parameters.begin())];
    if (!std::isnan(value)) throw core::InputError(place, "'" + name + "' is given twice.", "Give it once.");
    if (equals == std::string_view::npos || !core::parseNumber(part.substr(equals + 1), value) ||
        !std::isfinite(value)) {
      throw core::InputError(place, "'" + std::string(part) + "' gives no finite number.", "Write range_m=12.4.");
    }
  }
  for (std::size_t k = 0; k < point.size(); ++k) {
    if (std::isnan(point[k])) {
      throw core::InputError(place, "'" + parameters[k] + "' is missing.", "Give every parameter a value.");
    }
  }
  return point;
}

void check(const BoxRequest& boxes, const PredictRequest& request) {
  if (boxes.simulated.empty()) return;
  if (boxes.column.empty()) {
    throw core::InputError({.item = "--column"}, "is missing; it tells which values of the simulated files are meant.",
                           "Name the measurand of the predicted errors: --column range_m.");
  }
  if (request.at.size() != 1 || !request.at_file.empty()) {
    throw core::InputError({.item = "--simulated"}, "needs exactly one --at: the point at which this was simulated.",
                           "Give one --at and no --at-file; ask for other points in calls of their own.");
  }
}

}  // namespace

void check(const PredictRequest& request) {
  if (request.with.empty() == request.results.empty()) {
    throw core::InputError({.item = "RESULTS"}, "either RESULTS or --with must be given, not both.",
                           "Give validation results to learn from, or a prediction that was saved.");
  }
  if (request.with.empty() && request.columns.parameters.empty()) {
    throw core::InputError({.item = "--over"}, "is missing; an error is predicted over parameters.",
                           "Name their columns: --over range_m.");
  }
  if (!request.with.empty() && request.at.empty() && request.at_file.empty() && request.held_out.empty()) {
    throw core::InputError({.item = "--with"}, "a saved prediction is there to be asked.",
                           "Add --at, --at-file or --held-out.");
  }
  check(request.boxes, request);
  std::set<std::string> seen;
  for (const std::string& target : request.columns.targets) {
    if (!seen.insert(target).second) {
      throw core::InputError({.item = "--for " + target}, "is given twice.", "Give every error once.");
    }
  }
}

std::vector<std::vector<double>> queryPoints(const PredictRequest& request,
                                             const std::vector<std::string>& parameters) {
  std::vector<std::vector<double>> points;
  for (const std::string& words : request.at) points.push_back(pointOf(words, parameters));
  if (request.at_file.empty()) return points;
  const auto columns = core::readNumericColumns(request.at_file, parameters);
  for (std::size_t row = 0; row < columns.front().size(); ++row) {
    points.emplace_back();
    for (const auto& column : columns) points.back().push_back(column[row]);
  }
  return points;
}

}  // namespace app
