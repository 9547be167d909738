// fidelis spec export|import|check|trace: requirements, tests and data requirements of a project.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <ostream>

#include "app/cli/commands.h"
#include "app/cli/signature.h"
#include "core/error.h"
#include "specs/documents.h"
#include "specs/lists.h"
#include "specs/rules.h"
#include "specs/trace.h"

namespace app {

namespace {

struct Options {
  std::string project;
  std::map<std::string_view, std::string> targets;  ///< by name of the document format
  std::string folder;
  std::string id;
  std::string json;
  std::string author;
  bool prune = false;
  int relevant_from = specs::RuleOptions().relevant_from;
};

specs::Specification specificationOf(const Options& options) {
  return specs::ProjectStore::open(options.project, specs::Access::ReadOnly).specification();
}

void runExport(const Options& options, Session& session) {
  const bool any = std::any_of(options.targets.begin(), options.targets.end(),
                               [](const auto& target) { return !target.second.empty(); });
  if (!any) {
    throw core::InputError({.item = "spec export"}, "no document was asked for.",
                           "Give at least one of --html FILE, --xlsx FILE, --csv FOLDER, --json FILE.");
  }
  const specs::Specification specification = specificationOf(options);
  for (const specs::DocumentFormat& format : specs::documentFormats()) {
    const std::string& target = options.targets.at(format.name);
    if (target.empty()) continue;
    format.write(specification, target);
    if (!session.quiet) session.messages << "wrote " << target << "\n";
  }
}

void runImport(const Options& options, Session& session) {
  auto store = specs::ProjectStore::open(options.project);
  const specs::ReadLists lists = specs::readLists(options.folder, store.specification());
  const specs::ListChanges changes = specs::applyLists(store, lists, options.prune, signatureOf(options.author));
  if (session.quiet) return;
  session.messages << fmt::format("added: {}, changed: {}, removed: {}\n", changes.added, changes.changed,
                                  changes.removed);
  if (options.prune) return;
  for (const std::string& missing : lists.missing) {
    session.messages << missing << ": not in the lists; kept (--prune removes it).\n";
  }
}

nlohmann::ordered_json findingsJson(const std::vector<specs::RuleFinding>& findings) {
  auto list = nlohmann::ordered_json::array();
  for (const specs::RuleFinding& finding : findings) {
    list.push_back({{"rule", finding.rule},
                    {"level", std::string(percollect::toString(finding.severity))},
                    {"item", finding.item},
                    {"text", finding.text},
                    {"remedy", finding.remedy}});
  }
  return list;
}

void runCheck(const Options& options, Session& session) {
  const auto store = specs::ProjectStore::open(options.project, specs::Access::ReadOnly);
  const auto findings = specs::checkSpecification(store.specification(),
                                                  {.relevant_from = options.relevant_from, .folder = store.folder()});
  const auto count = [&](specs::Severity severity) {
    return std::count_if(findings.begin(), findings.end(),
                         [&](const auto& finding) { return finding.severity == severity; });
  };
  const auto errors = count(specs::Severity::Error);
  if (!options.json.empty()) {
    session.writeJsonTo(
        options.json,
        {{"errors", errors}, {"warnings", count(specs::Severity::Warning)}, {"findings", findingsJson(findings)}});
  }
  if (options.json != "-") {
    for (const specs::RuleFinding& finding : findings) session.out << specs::toString(finding) << "\n";
    session.out << fmt::format("errors: {}, warnings: {}\n", errors, count(specs::Severity::Warning));
  }
  if (errors > 0) session.status = kNotAccepted;
}

void runTrace(const Options& options, Session& session) {
  session.out << specs::traceText(specificationOf(options), options.id);
}

CLI::App* addStep(CLI::App& command, const char* name, const char* help, const std::shared_ptr<Options>& options,
                  Session& session, void (*run)(const Options&, Session&)) {
  CLI::App* step = command.add_subcommand(name, help);
  step->add_option("--project", options->project, "Project file")->required();
  step->callback([options, &session, run] { run(*options, session); });
  return step;
}

void addExport(CLI::App& command, const std::shared_ptr<Options>& options, Session& session) {
  CLI::App* step = addStep(command, "export", "Write the specification as documents", options, session, runExport);
  for (const specs::DocumentFormat& format : specs::documentFormats()) {
    step->add_option("--" + std::string(format.name), options->targets[format.name], std::string(format.title));
  }
}

void addImport(CLI::App& command, const std::shared_ptr<Options>& options, Session& session) {
  CLI::App* step =
      addStep(command, "import", "Take the lists of a folder, as export --csv wrote them", options, session, runImport);
  step->add_option("FOLDER", options->folder, "Folder with requirements.csv, acceptance_tests.csv, links.csv, …")
      ->required();
  step->add_flag("--prune", options->prune, "Remove what the lists no longer have");
  step->add_option("--author", options->author, "Who imports, for the history (default: the login name)");
}

std::string rulesText() {
  std::string text = "Rules:\n";
  for (const specs::Rule& rule : specs::allRules()) {
    text += fmt::format("  {:<29} {:<8} {}\n", rule.uid, percollect::toString(rule.severity), rule.title);
  }
  return text;
}

void addCheck(CLI::App& command, const std::shared_ptr<Options>& options, Session& session) {
  CLI::App* step =
      addStep(command, "check", "Does it hold together? Exit status 1 for errors", options, session, runCheck);
  step->add_option("--relevant-from", options->relevant_from, "Rows of this relevance (O + I) need a requirement")
      ->capture_default_str()
      ->check(CLI::Range(2, 20));
  step->add_option("--json", options->json, "Write the findings as JSON to this file (-: standard output)");
  step->footer(rulesText());
}

void addTrace(CLI::App& command, const std::shared_ptr<Options>& options, Session& session) {
  CLI::App* step =
      addStep(command, "trace", "Show what an item follows from and what it leads to", options, session, runTrace);
  step->add_option("ID", options->id, "Id of a requirement, test or data requirement, or key of a CEPRA row")
      ->required();
}

}  // namespace

void addSpecCommand(CLI::App& program, Session& session) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("spec", "The specification: requirements, acceptance tests, data requirements");
  command->require_subcommand(1);
  command->footer(
      "Examples:\n"
      "  fidelis spec export --project demo.fidelis --html spec.html --xlsx spec.xlsx --csv lists\n"
      "  fidelis spec import lists --project demo.fidelis\n"
      "  fidelis spec check --project demo.fidelis\n"
      "  fidelis spec trace RangeError_Fog_1 --project demo.fidelis");
  addExport(*command, options, session);
  addImport(*command, options, session);
  addCheck(*command, options, session);
  addTrace(*command, options, session);
}

}  // namespace app
