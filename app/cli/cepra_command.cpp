// fidelis cepra build|export|import|check, and what a diagnosis proposes for it: the relevance table of a project.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <ostream>

#include "app/cli/cepra/proposal_steps.h"
#include "app/cli/commands.h"
#include "app/cli/signature.h"
#include "cepra/check.h"
#include "cepra/csv.h"
#include "core/error.h"
#include "percollect/read_graph.h"
#include "specs/import_graph.h"

namespace app {

namespace {

struct Options {
  std::string graph;
  std::string project;
  std::string csv;
  std::string json;
  std::string author;
};

/// The table of a project; an error if there is none.
cepra::Table tableOf(const specs::ProjectStore& store) {
  cepra::Table table = store.cepra();
  if (table.rows.empty()) {
    throw core::InputError({.file = store.file()}, "the project has no relevance table yet.",
                           "Import a graph first: fidelis import GRAPH --project FILE.");
  }
  return table;
}

void writeCsv(const cepra::Table& table, const std::string& csv, Session& session) {
  if (csv == "-") {
    session.out << cepra::toCsv(table);
    return;
  }
  cepra::exportCsv(table, csv);
  if (!session.quiet) session.messages << fmt::format("{} rows written to {}\n", table.rows.size(), csv);
}

void runBuild(const Options& options, Session& session) {
  if (options.graph.empty() == options.project.empty()) {
    throw core::InputError({.item = "cepra build"}, "give either a graph or a project.",
                           "fidelis cepra build GRAPH --csv FILE, or fidelis cepra build --project FILE --csv FILE.");
  }
  if (!options.graph.empty()) {
    return writeCsv(cepra::buildTable(percollect::readGraph(options.graph).graph), options.csv, session);
  }
  const auto store = specs::ProjectStore::open(options.project, specs::Access::ReadOnly);
  const auto graph = store.graph();
  if (!graph) {
    throw core::InputError({.file = options.project}, "the project has no graph.",
                           "Import one first: fidelis import GRAPH --project FILE.");
  }
  writeCsv(cepra::buildTable(*graph), options.csv, session);
}

void runExport(const Options& options, Session& session) {
  writeCsv(tableOf(specs::ProjectStore::open(options.project, specs::Access::ReadOnly)), options.csv, session);
}

void runImport(const Options& options, Session& session) {
  auto store = specs::ProjectStore::open(options.project);
  const cepra::CsvImport read = cepra::importCsv(tableOf(store), options.csv);
  store.saveCepra(read.table, signatureOf(options.author));
  if (session.quiet) return;
  for (const cepra::Finding& finding : read.findings) session.messages << cepra::toString(finding) << "\n";
  session.messages << fmt::format("{} of {} rows changed\n", read.changed, read.table.rows.size());
}

nlohmann::ordered_json findingsJson(const std::vector<cepra::Finding>& findings) {
  auto list = nlohmann::ordered_json::array();
  for (const cepra::Finding& finding : findings) {
    list.push_back({{"level", std::string(percollect::toString(finding.severity))},
                    {"row", finding.row},
                    {"column", finding.column},
                    {"text", finding.text},
                    {"remedy", finding.remedy}});
  }
  return list;
}

void runCheck(const Options& options, Session& session) {
  const cepra::Table table = tableOf(specs::ProjectStore::open(options.project, specs::Access::ReadOnly));
  const std::vector<cepra::Finding> findings = cepra::check(table);
  const auto scored =
      std::count_if(table.rows.begin(), table.rows.end(), [](const auto& row) { return row.isScored(); });
  const auto suspect =
      std::count_if(table.rows.begin(), table.rows.end(), [](const auto& row) { return row.isSuspect(); });
  const bool bad = std::any_of(findings.begin(), findings.end(),
                               [](const auto& finding) { return finding.severity == cepra::Severity::Error; });
  if (!options.json.empty()) {
    session.writeJsonTo(
        options.json,
        {{"rows", table.rows.size()}, {"scored", scored}, {"suspect", suspect}, {"findings", findingsJson(findings)}});
  }
  if (options.json != "-") {
    for (const cepra::Finding& finding : findings) session.out << cepra::toString(finding) << "\n";
    session.out << fmt::format("rows: {}, scored: {}, suspect: {}, findings: {}\n", table.rows.size(), scored, suspect,
                               findings.size());
  }
  if (bad) session.status = kNotAccepted;
}

CLI::App* addStep(CLI::App& command, const char* name, const char* help, const std::shared_ptr<Options>& options,
                  Session& session, void (*run)(const Options&, Session&)) {
  CLI::App* step = command.add_subcommand(name, help);
  step->callback([options, &session, run] { run(*options, session); });
  return step;
}

}  // namespace

void addCepraCommand(CLI::App& program, Session& session) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("cepra", "The relevance table: how often causes occur, how bad their effects are (CEPRA)");
  command->require_subcommand(1);
  command->footer(
      "Examples:\n"
      "  fidelis cepra export --project demo.fidelis --csv cepra.csv     then score it in a spreadsheet\n"
      "  fidelis cepra import cepra.csv --project demo.fidelis\n"
      "  fidelis cepra check --project demo.fidelis\n"
      "  fidelis cepra propose gap.json --project demo.fidelis           what a diagnosis means for it\n"
      "  fidelis cepra accept P1 --project demo.fidelis");

  CLI::App* build = addStep(*command, "build", "Write the unscored table of a graph", options, session, runBuild);
  build->add_option("GRAPH", options->graph, "PerCollECT release; or use the graph of --project");
  build->add_option("--project", options->project, "Project file with a graph");
  build->add_option("--csv", options->csv, "CSV file to write (-: standard output)")->required();

  CLI::App* write =
      addStep(*command, "export", "Write the table as CSV for a spreadsheet", options, session, runExport);
  write->add_option("--project", options->project, "Project file")->required();
  write->add_option("--csv", options->csv, "CSV file to write (-: standard output)")->required();

  CLI::App* read =
      addStep(*command, "import", "Take scores, rationales and notes from a CSV", options, session, runImport);
  read->add_option("CSV", options->csv, "File that 'cepra export' wrote and somebody edited")->required();
  read->add_option("--project", options->project, "Project file")->required();
  read->add_option("--author", options->author, "Who imports, for the history (default: the login name)");

  CLI::App* check =
      addStep(*command, "check", "Is every score complete? Exit status 1 for errors", options, session, runCheck);
  check->add_option("--project", options->project, "Project file")->required();
  check->add_option("--json", options->json, "Write the findings as JSON to this file (-: standard output)");
  addProposalSteps(*command, session);
}

}  // namespace app
