#include "app/cli/validity/levels.h"

#include <algorithm>
#include <fmt/format.h>

#include "core/csv.h"
#include "core/error.h"
#include "core/json_object.h"
#include "core/text.h"

namespace app {

namespace {

/// Adds one metric. Alone it is a gap of its own: that scales it, and tells what is wrong at its place in the file.
void add(std::vector<Level>& levels, const std::string& level, LevelMetric entry, const core::Place& place) {
  auto found = std::find_if(levels.begin(), levels.end(), [&](const Level& known) { return known.name == level; });
  if (found == levels.end()) found = levels.insert(levels.end(), {.name = level, .metrics = {}});
  for (const LevelMetric& known : found->metrics) {
    if (known.metric.name != entry.metric.name) continue;
    throw core::InputError(place, fmt::format("has metric '{}' twice at level '{}'.", entry.metric.name, level),
                           "Give every metric of a level once, or name the two differently.");
  }
  try {
    entry.scaled = metrics::ngoGap(std::vector{metrics::FidelityLevel{level, {entry.metric}}}).gap;
  } catch (const core::InputError& error) {
    const std::string item = place.item.empty() ? error.place().item : place.item + ", " + error.place().item;
    throw core::InputError({.file = place.file, .line = place.line, .item = item}, error.problem(), error.remedy());
  }
  found->metrics.push_back(std::move(entry));
}

double numberIn(const core::CsvTable& table, std::size_t row, const std::string& column) {
  const std::string& text = table.rows[row][table.column(column)];
  double number = 0.0;
  if (core::parseNumber(text, number)) return number;
  throw core::InputError({.file = table.file, .line = table.lines[row], .item = "column '" + column + "'"},
                         "'" + text + "' is not a number.", "Write a number with a decimal point.");
}

std::string nameIn(const core::CsvTable& table, std::size_t row, const std::string& column) {
  std::string text = core::trimmed(table.rows[row][table.column(column)]);
  if (!text.empty()) return text;
  throw core::InputError({.file = table.file, .line = table.lines[row], .item = "column '" + column + "'"}, "is empty.",
                         "Name the level and the metric on every row.");
}

std::vector<Level> levelsInCsv(const std::string& file) {
  const core::CsvTable table = core::readCsvTable(file);
  const auto unit = table.findColumn("unit");
  std::vector<Level> levels;
  for (const char* needed : {"level", "metric", "value", "maximum"}) (void)table.column(needed);
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    LevelMetric entry{.metric = {.name = nameIn(table, row, "metric"),
                                 .value = numberIn(table, row, "value"),
                                 .maximum = numberIn(table, row, "maximum")},
                      .unit = unit ? core::trimmed(table.rows[row][*unit]) : "",
                      .scaled = 0.0};
    add(levels, nameIn(table, row, "level"), std::move(entry), {.file = file, .line = table.lines[row]});
  }
  if (levels.empty()) {
    throw core::InputError({.file = file}, "has a header and no rows.",
                           "Write one row a metric: level,metric,value,maximum.");
  }
  return levels;
}

std::vector<Level> levelsInJson(const std::string& file) {
  const nlohmann::json value = core::readJson(file);
  core::JsonObject document(value, file);
  document.expectFormat("fidelis-levels", 1);
  std::vector<Level> levels;
  document.eachObject("levels", [&](core::JsonObject& level) {
    const std::string name = level.text("name");
    const std::size_t before = levels.size();
    level.eachObject("metrics", [&](core::JsonObject& metric) {
      LevelMetric entry{
          .metric = {.name = metric.text("name"), .value = metric.number("value"), .maximum = metric.number("maximum")},
          .unit = metric.textOr("unit", ""),
          .scaled = 0.0};
      add(levels, name, std::move(entry), {.file = file, .item = metric.pointer()});
    });
    level.finish();  // a misspelt key is told before what it leaves missing
    if (levels.size() > before) return;
    level.fail("metrics", "gives no metric, or level '" + name + "' was there before.",
               "Give every level once, with one metric or more.");
  });
  document.finish();
  if (levels.empty()) document.fail("levels", "holds no level.", "Give at least one; the paper has four.");
  return levels;
}

}  // namespace

std::vector<Level> readLevels(const std::string& file) {
  const bool json = file.ends_with(".json") || file.ends_with(".json.gz");
  return json ? levelsInJson(file) : levelsInCsv(file);
}

}  // namespace app
