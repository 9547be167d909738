#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <ostream>

#include "app/cli/validity/levels.h"
#include "app/cli/validity/output.h"
#include "app/cli/validity/validity.h"
#include "core/text.h"

namespace app {

using nlohmann::ordered_json;

namespace {

constexpr Method kMethod{.kind = "gap",
                         .title = "Mean over fidelity levels of the mean of value / maximum",
                         .source = "Ngo, Bauer & Resch 2021, arXiv:2106.08372; the maxima are inputs"};

metrics::NgoGap gapOf(const std::vector<Level>& levels) {
  std::vector<metrics::FidelityLevel> plain;
  for (const Level& level : levels) {
    plain.push_back({.name = level.name, .metrics = {}});
    for (const LevelMetric& entry : level.metrics) plain.back().metrics.push_back(entry.metric);
  }
  return metrics::ngoGap(plain);
}

void writeGap(const std::vector<Level>& levels, const metrics::NgoGap& gap, std::ostream& out) {
  out << fmt::format(
      "Simulation-to-reality gap (Ngo et al. 2021): {}\n"
      "  0: none, 1: as large as the maxima; no unit; mean of {} levels. Compare only gaps with the same maxima.\n\n",
      core::significant(gap.gap, 4), levels.size());
  std::vector<std::vector<std::string>> table{{"level", "gap", "metric", "value / maximum", "scaled"}};
  for (std::size_t i = 0; i < levels.size(); ++i) {
    bool first = true;
    for (const LevelMetric& entry : levels[i].metrics) {
      table.push_back({first ? levels[i].name : "", first ? core::significant(gap.levels[i], 4) : "", entry.metric.name,
                       fmt::format("{} / {}{}", core::significant(entry.metric.value, 6),
                                   core::significant(entry.metric.maximum, 6), unitBehind(entry.unit)),
                       core::significant(entry.scaled, 4)});
      first = false;
    }
  }
  writeTable(table, out);
}

ordered_json documentOf(const std::vector<Level>& levels, const metrics::NgoGap& gap, const std::string& file) {
  ordered_json document = validityDocument(kMethod);
  document["file"] = file;
  document["gap"] = gap.gap;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    ordered_json level{{"name", levels[i].name}, {"gap", gap.levels[i]}};
    for (const LevelMetric& entry : levels[i].metrics) {
      level["metrics"].push_back({{"name", entry.metric.name},
                                  {"value", entry.metric.value},
                                  {"maximum", entry.metric.maximum},
                                  {"unit", entry.unit},
                                  {"scaled", entry.scaled}});
    }
    document["levels"].push_back(std::move(level));
  }
  return document;
}

const char* const kFooter =
    "LEVELS is a CSV file, one row a metric; every level weighs the same, however many metrics it has. A metric is 0 "
    "at\n"
    "best and its maximum counts as 1: the largest value among the models that are compared, or one that is as bad as\n"
    "can be. The paper does not fix the maxima. Give a similarity (1 is best) as 1 - value. 'fidelis metric --json'\n"
    "computes such metrics.\n\n"
    "Example of a file (unit may be left out; the same as JSON is described in formats.md):\n"
    "  level,metric,value,maximum,unit\n"
    "  objects,ospa,0.8,4,m\n"
    "  objects,1 - iou,0.3,1,\n"
    "  point clouds,wasserstein_1,0.12,0.5,m\n\n"
    "Example:\n"
    "  fidelis validity gap levels.csv --json gap.json";

}  // namespace

void addFidelityGap(CLI::App& validity, Session& session) {
  struct Request {
    std::string levels;
    std::string json;
  };
  auto request = std::make_shared<Request>();
  CLI::App* command = validity.add_subcommand(
      "gap", "Ngo's gap: metrics of each fidelity level, scaled by their maxima, in one number");
  command->add_option("LEVELS", request->levels, "Metrics by level: a CSV file, or JSON (*.json)")->required();
  command->add_option("--json", request->json, "Write the result as JSON to this file (-: standard output)");
  command->footer(kFooter);
  command->callback([request, &session] {
    const std::vector<Level> levels = readLevels(request->levels);
    const metrics::NgoGap gap = gapOf(levels);
    if (request->json.empty()) {
      writeGap(levels, gap, session.out);
    } else {
      session.writeJsonTo(request->json, documentOf(levels, gap, request->levels));
    }
  });
}

}  // namespace app
