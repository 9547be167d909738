// fidelis import GRAPH: a PerCollECT release into a project file, or just its counts.

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <ostream>

#include "app/cli/commands.h"
#include "app/cli/signature.h"
#include "cepra/table.h"
#include "core/error.h"
#include "percollect/chains.h"
#include "percollect/read_graph.h"
#include "specs/import_graph.h"

namespace app {

namespace {

struct Options {
  std::string graph;
  std::string project;
  std::string json;
  std::string tree;
  std::string author;
  bool attach_orphans = false;
};

nlohmann::ordered_json reportJson(const percollect::ReadGraph& read) {
  const percollect::GraphCounts counts = percollect::countGraph(read.graph);
  auto warnings = nlohmann::ordered_json::array();
  for (const percollect::Finding& finding : read.findings) {
    if (finding.severity == percollect::Severity::Note) continue;
    warnings.push_back({{"file", finding.file.string()},
                        {"line", finding.line},
                        {"node", finding.node},
                        {"text", finding.text + (finding.remedy.empty() ? "" : " " + finding.remedy)}});
  }
  return {{"nodes", counts.nodes},
          {"edges", counts.edges},
          {"phenomena", counts.phenomena},
          {"chains", counts.chains.value},
          {"cepra_rows", cepra::countRows(read.graph)},
          {"warnings", warnings}};
}

/// Findings on standard error, notes only with --verbose.
void tellFindings(const std::vector<percollect::Finding>& findings, const Session& session) {
  std::size_t notes = 0;
  for (const percollect::Finding& finding : findings) {
    const bool is_note = finding.severity == percollect::Severity::Note;
    notes += is_note;
    if (!session.quiet && (!is_note || session.verbose)) session.messages << percollect::toString(finding) << "\n";
  }
  if (notes > 0 && !session.verbose && !session.quiet) {
    session.messages << "notes on the graph: " << notes << "; --verbose shows them.\n";
  }
}

std::string countsText(const percollect::Graph& graph) {
  const percollect::GraphCounts counts = percollect::countGraph(graph);
  return fmt::format(
      "{}: {} nodes ({} effects, {} design parameters, {} system-independent causes), {} edges\n"
      "{} phenomena, {}{} chains (longest {} edges), {} CEPRA rows\n",
      graph.tree(), counts.nodes, counts.effects, counts.design_parameters, counts.system_independent, counts.edges,
      counts.phenomena, counts.chains.saturated ? "at least " : "", counts.chains.value, counts.longest_path,
      cepra::countRows(graph));
}

std::string importText(const specs::ImportedGraph& imported, const std::string& project) {
  if (imported.unchanged) return fmt::format("{} holds this release already; nothing was changed.\n", project);
  if (imported.first) return fmt::format("Imported into {}: {} CEPRA rows.\n", project, imported.rows);
  std::string text = fmt::format("{} had an earlier release. What changed in the graph:\n", project);
  for (const percollect::NodeChange& change : imported.difference.changes) {
    const std::string& id = change.new_id.empty() ? change.old_id : change.new_id;
    text += fmt::format("  {} {} '{}': {}\n", percollect::toString(change.kind), id, change.title, change.text);
  }
  if (imported.difference.empty()) text += "  nothing\n";
  text += fmt::format("CEPRA rows: {} now, {} new, {} dropped (they held nothing), {} suspect\n", imported.rows,
                      imported.added.size(), imported.dropped.size(), imported.suspect.size());
  for (const std::string& key : imported.suspect) text += "  suspect row " + key + "\n";
  for (const specs::Link& link : imported.suspect_links) {
    text += fmt::format("  suspect link {} -> {}\n", link.from, link.to);
  }
  if (!imported.suspect.empty()) text += "Look at these rows; 'fidelis cepra check' says what changed in each.\n";
  return text;
}

std::string putInto(const std::string& project, const percollect::Graph& graph, const std::string& author) {
  auto store =
      std::filesystem::exists(project) ? specs::ProjectStore::open(project) : specs::ProjectStore::create(project);
  return importText(specs::importGraph(store, graph, signatureOf(author)), project);
}

void runImport(const Options& options, Session& session) {
  if (options.project.empty() && options.json.empty()) {
    throw core::InputError({.item = "--project"}, "nothing says what to do with the graph.",
                           "Give --project FILE to import it, or --json - to count only.");
  }
  const percollect::ReadGraph read =
      percollect::readGraph(options.graph, {.tree = options.tree, .attach_orphans = options.attach_orphans});
  tellFindings(read.findings, session);
  // With the JSON on standard output, words for people go elsewhere.
  std::ostream& words = options.json == "-" ? session.messages : session.out;
  const bool speak = !(session.quiet && options.json == "-");
  if (speak) words << countsText(read.graph);
  if (!options.project.empty()) {
    const std::string text = putInto(options.project, read.graph, options.author);
    if (speak) words << text;
  }
  if (!options.json.empty()) session.writeJsonTo(options.json, reportJson(read));
}

}  // namespace

void addImportCommand(CLI::App& program, Session& session) {
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("import", "Read a cause-effect graph (PerCollECT) into a project file");
  command->add_option("GRAPH", options->graph, "Folder or root_node.xml of the XML release, or the JSON release")
      ->required();
  command->add_option("--project", options->project, "Project file; made if it does not exist");
  command->add_option("--json", options->json, "Write counts and warnings as JSON to this file (-: standard output)");
  command->add_option("--tree", options->tree, "Name of the tree through its releases (default: from the file name)");
  command->add_flag("--attach-orphans", options->attach_orphans,
                    "Give nodes without effect the parent that their drawing hint names");
  command->add_option("--author", options->author, "Who imports, for the history (default: the login name)");
  command->footer(
      "A newer release of the same tree is merged: the difference is printed, scores stay with their rows, and rows\n"
      "whose meaning may have changed are marked suspect. A broken file leaves the project as it was.\n"
      "Examples:\n"
      "  fidelis import lidarlimbs.json --project demo.fidelis\n"
      "  fidelis import LidarLimbs/data --json -");
  command->callback([options, &session] { runImport(*options, session); });
}

}  // namespace app
