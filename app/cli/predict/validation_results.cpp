#include "app/cli/predict/validation_results.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <optional>

#include "core/csv.h"
#include "core/error.h"
#include "core/json_object.h"
#include "core/text.h"

namespace app {

namespace {

using metrics::ErrorSamples;

/// One sample, whatever it was read from.
struct Row {
  std::vector<double> point;
  std::vector<double> errors;  ///< one a target
  double weight = 1.0;
  std::string setup;
};

std::vector<ErrorSamples> emptySamples(const ResultColumns& columns) {
  std::vector<ErrorSamples> all;
  for (const std::string& target : columns.targets) {
    all.push_back({.target = target, .parameters = columns.parameters, .points = {}, .errors = {}});
  }
  return all;
}

void add(std::vector<ErrorSamples>& all, const Row& row, const ResultColumns& columns) {
  for (std::size_t t = 0; t < all.size(); ++t) {
    all[t].points.insert(all[t].points.end(), row.point.begin(), row.point.end());
    all[t].errors.push_back(row.errors[t]);
    all[t].setups.push_back(row.setup);
    if (!columns.weight.empty()) all[t].weights.push_back(row.weight);
  }
}

void demandSamples(const ValidationResults& results) {
  if (results.seen.empty() || results.seen.front().size() > 0) return;
  const std::string why =
      results.left_out.empty() ? "" : " " + results.left_out.front().where + ": " + results.left_out.front().why;
  throw core::InputError({.file = results.file}, "has no sample to learn from." + why,
                         "Give rows of role validation, or without a role.");
}

/// The default where nobody asked: what is there of the double validation metric.
std::vector<std::string> chosenTargets(const ResultColumns& columns, const std::vector<std::string>& there,
                                       const std::filesystem::path& file) {
  if (!columns.targets.empty()) return columns.targets;
  std::vector<std::string> targets;
  for (const char* usual : {"d_bias", "d_cavm"}) {
    if (std::find(there.begin(), there.end(), usual) != there.end()) targets.emplace_back(usual);
  }
  if (targets.empty()) {
    throw core::InputError({.file = file, .line = 1}, "has neither a column 'd_bias' nor 'd_cavm'.",
                           "Name the error to predict with --for; there are " + core::join(there) + ".");
  }
  return targets;
}

class ResultsTable {
 public:
  ResultsTable(const std::filesystem::path& file, const ResultColumns& columns)
      : table_(core::readCsvTable(file)), columns_(columns) {
    columns_.targets = chosenTargets(columns, table_.header, file);
    setup_ = columns.setup.empty() ? table_.findColumn("setup") : table_.column(columns.setup);
    if (columns.every_role) return;
    role_ = columns.role.empty() ? table_.findColumn("role") : table_.column(columns.role);
  }

  [[nodiscard]] ValidationResults read() const {
    ValidationResults results{.file = table_.file, .seen = {}, .held_out = {}, .left_out = {}};
    results.seen = emptySamples(columns_);
    results.held_out = results.seen;
    for (std::size_t i = 0; i < table_.rows.size(); ++i) {
      const std::string role = roleOf(i);
      if (role == "calibration") {
        results.left_out.push_back(
            {.where = fmt::format("line {}", table_.lines[i]), .why = "the model was fitted to it (role calibration)"});
        continue;
      }
      add(role == "prediction" ? results.held_out : results.seen, row(i), columns_);
    }
    demandSamples(results);
    return results;
  }

 private:
  [[nodiscard]] Row row(std::size_t i) const {
    Row row;
    for (const std::string& name : columns_.parameters) row.point.push_back(number(i, name));
    for (const std::string& name : columns_.targets) row.errors.push_back(error(i, name));
    if (!columns_.weight.empty()) row.weight = number(i, columns_.weight);
    if (setup_) row.setup = table_.rows[i][*setup_];
    return row;
  }

  [[nodiscard]] double number(std::size_t i, const std::string& name) const {
    const std::string& cell = table_.rows[i][table_.column(name)];
    double value = 0.0;
    if (!core::parseNumber(cell, value) || !std::isfinite(value)) {
      throw core::InputError(place(i, name), "'" + cell + "' is not a finite number.",
                             "Write a number with a decimal point, or remove the row.");
    }
    return value;
  }

  [[nodiscard]] double error(std::size_t i, const std::string& name) const {
    const double value = number(i, name);
    if (value < 0.0 && isNeverNegative(name)) {
      throw core::InputError(place(i, name), core::shortestNumber(value) + " is negative; " + name + " never is.",
                             "Check which column is which.");
    }
    return value;
  }

  [[nodiscard]] std::string roleOf(std::size_t i) const {
    if (!role_) return "validation";
    const std::string role = core::lowerCase(core::trimmed(table_.rows[i][*role_]));
    static const std::vector<std::string> kRoles{"calibration", "validation", "prediction"};
    if (role.empty()) return "validation";
    if (std::find(kRoles.begin(), kRoles.end(), role) == kRoles.end()) {
      throw core::InputError(place(i, table_.header[*role_]), "'" + role + "' is no role.",
                             "Roles are " + core::join(kRoles) + ".");
    }
    return role;
  }

  [[nodiscard]] core::Place place(std::size_t i, const std::string& column) const {
    return {.file = table_.file, .line = table_.lines[i], .item = "column '" + column + "'"};
  }

  core::CsvTable table_;
  ResultColumns columns_;
  std::optional<std::size_t> setup_;
  std::optional<std::size_t> role_;
};

/// Objects of a list whose other keys are of no interest here.
template <typename Read>
void eachIn(core::JsonObject& parent, const std::string& key, Read read) {
  const nlohmann::json& list = parent.raw(key);
  for (std::size_t i = 0; i < list.size(); ++i) {
    read(core::JsonObject(list.at(i), parent.file(), fmt::format("{}/{}/{}", parent.pointer(), key, i)));
  }
}

/// The test that is named, or the only one.
core::JsonObject testNamed(core::JsonObject& report, const std::string& id) {
  std::optional<core::JsonObject> found;
  std::vector<std::string> ids;
  eachIn(report, "tests", [&](core::JsonObject test) {
    ids.push_back(test.text("id"));
    if (id.empty() || ids.back() == id) found = test;
  });
  if (found && (!id.empty() || ids.size() == 1)) return *found;
  const std::string nearest = core::nearestName(id, ids);
  throw core::InputError(
      {.file = report.file(), .item = "--test"},
      id.empty() ? fmt::format("one test must be named; the report has {}.", ids.size())
                 : "the report has no test '" + id + "'.",
      nearest.empty() ? "Its tests are " + core::join(ids) + "." : "Did you mean '" + nearest + "'?");
}

/// A number of the sample; absent if it is null there. A name that the sample does not have is refused.
std::optional<double> numberNamed(core::JsonObject object, const std::string& name) {
  const std::vector<std::string> known = object.keys();
  if (std::find(known.begin(), known.end(), name) == known.end()) {
    const std::string nearest = core::nearestName(name, known);
    object.fail(name, "is not in this sample.",
                nearest.empty() ? "It has " + core::join(known) + "." : "Did you mean '" + nearest + "'?");
  }
  return object.optionalNumber(name);
}

std::vector<std::optional<double>> numbersNamed(core::JsonObject& sample, const std::string& key,
                                                const std::vector<std::string>& names) {
  std::vector<std::optional<double>> numbers;
  for (const std::string& name : names) numbers.push_back(numberNamed(sample.object(key), name));
  return numbers;
}

/// False if one is undefined.
bool takeAll(const std::vector<std::optional<double>>& numbers, std::vector<double>& into) {
  for (const auto& number : numbers) {
    if (!number) return false;
    into.push_back(*number);
  }
  return true;
}

}  // namespace

ValidationResults readResultsTable(const std::filesystem::path& file, const ResultColumns& columns) {
  return ResultsTable(file, columns).read();
}

ValidationResults readAcceptanceReport(const std::filesystem::path& file, const ResultColumns& columns,
                                       const std::string& test) {
  if (!columns.weight.empty()) {
    throw core::InputError({.file = file, .item = "--weight"}, "names a column; a report has none.",
                           "Leave --weight out, or give a CSV file.");
  }
  const nlohmann::json document = core::readJson(file);
  core::JsonObject report(document, file);
  report.expectFormat("fidelis-acceptance", 1);
  core::JsonObject chosen = testNamed(report, test);
  ResultColumns named = columns;
  if (named.targets.empty()) named.targets = {"d_bias", "d_cavm"};
  ValidationResults results{.file = file, .seen = emptySamples(named), .held_out = emptySamples(named), .left_out = {}};
  if (chosen.has("measurand")) {
    results.measurand = {
        .name = chosen.text("measurand"), .column = chosen.textOr("column", ""), .unit = chosen.textOr("unit", "")};
  }
  eachIn(chosen, "samples", [&](core::JsonObject sample) {
    Row row;
    const bool complete = takeAll(numbersNamed(sample, "parameters", named.parameters), row.point) &&
                          takeAll(numbersNamed(sample, "values", named.targets), row.errors);
    if (complete) {
      add(results.seen, row, named);
    } else {
      results.left_out.push_back({.where = sample.text("id"), .why = "a value is undefined"});
    }
  });
  demandSamples(results);
  return results;
}

bool isNeverNegative(const std::string& target) {
  static constexpr std::array<std::string_view, 5> kStems{"d_cavm", "d_avm", "d_plus", "d_minus", "wasserstein"};
  return std::any_of(kStems.begin(), kStems.end(), [&](std::string_view stem) { return target.starts_with(stem); });
}

}  // namespace app
