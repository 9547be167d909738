#include "app/cli/sensitivity/design_file.h"

#include <algorithm>
#include <fmt/format.h>

#include "core/csv.h"
#include "core/error.h"
#include "core/file.h"
#include "core/json_object.h"
#include "core/text.h"

namespace app {

using metrics::SensitivityMethod;
using metrics::SensitivityPlan;
using metrics::UncertainParameter;

std::vector<UncertainParameter> readParameters(const std::string& file) {
  const nlohmann::json json = core::readJson(file);
  core::JsonObject object(json, file);
  object.expectFormat("fidelis-parameters", 1);
  std::vector<UncertainParameter> parameters;
  object.eachObject("parameters", [&](core::JsonObject& one) {
    parameters.push_back({.name = one.text("name"),
                          .min = one.number("min"),
                          .max = one.number("max"),
                          .logarithmic = one.flagOr("logarithmic", false)});
    one.finish();
  });
  object.finish();
  return parameters;
}

void writeDesign(const std::string& file, const SensitivityPlan& plan) {
  std::vector<std::string> fields{"block", "curve"};
  for (const UncertainParameter& parameter : plan.parameters) fields.push_back(parameter.name);
  std::string text = core::csvRecord(fields);
  for (std::size_t row = 0; row < plan.rows.size(); ++row) {
    fields = {plan.blockOf(row), std::to_string(plan.curveOf(row))};
    for (const double value : plan.rows[row]) fields.push_back(core::shortestNumber(value));
    text += core::csvRecord(fields);
  }
  core::writeFile(file, text);
}

SensitivityPlan readDesign(const std::string& file) {
  const core::CsvTable table = core::readCsvTable(file);
  const auto fail = [&](int line, const std::string& problem) {
    throw core::InputError({.file = file, .line = line}, problem,
                           "Give a design as 'fidelis sensitivity design' writes it, with all rows in their order.");
  };
  if (table.header.size() < 3 || table.header[0] != "block" || table.header[1] != "curve") {
    fail(1, "is no design: its columns must be block, curve and the parameters.");
  }
  if (table.rows.empty()) fail(1, "has no rows.");
  SensitivityPlan plan;
  for (std::size_t i = 2; i < table.header.size(); ++i) {
    plan.parameters.push_back({.name = table.header[i], .min = 0.0, .max = 1.0, .logarithmic = false});
  }
  const std::string& first = table.rows.front()[0];
  plan.method = first == "A" ? SensitivityMethod::Sobol : SensitivityMethod::Fast;
  while (plan.n < table.rows.size() && table.rows[plan.n][0] == first && table.rows[plan.n][1] == "1") ++plan.n;
  if (plan.n == 0) fail(table.lines.front(), "begins with curve " + table.rows.front()[1] + ".");
  const std::size_t k = plan.parameters.size();
  if (plan.method == SensitivityMethod::Fast) plan.curves = table.rows.size() / (plan.n * k);
  const std::size_t wanted = metrics::rowCount(plan);
  if (table.rows.size() != wanted || plan.curves == 0) {
    fail(table.lines.back(),
         fmt::format("has {} rows; a {} design of {} parameters with blocks of {} has {}.", table.rows.size(),
                     first == "A" ? "Sobol'" : "FAST", k, plan.n, std::max(wanted, plan.n * k)));
  }
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    if (table.rows[row][0] == plan.blockOf(row) && table.rows[row][1] == std::to_string(plan.curveOf(row))) continue;
    fail(table.lines[row], fmt::format("is of block '{}', curve {}, where '{}', curve {} is due.", table.rows[row][0],
                                       table.rows[row][1], plan.blockOf(row), plan.curveOf(row)));
  }
  return plan;
}

}  // namespace app
