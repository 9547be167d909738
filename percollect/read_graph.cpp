#include "percollect/read_graph.h"

#include <algorithm>
#include <array>
#include <regex>

#include "core/error.h"
#include "core/file.h"
#include "core/text.h"
#include "percollect/references.h"
#include "percollect/release_readers.h"

namespace percollect {

namespace fs = std::filesystem;

namespace {

/// The first of the usual places in a folder that holds a release; empty if none does.
fs::path releaseIn(const fs::path& folder) {
  for (const char* place : {"root_node.xml", "data/root_node.xml", "data.json", "data/data.json", "src/data.json"}) {
    if (fs::is_regular_file(folder / place)) return folder / place;
  }
  return {};
}

Release readRelease(const fs::path& path) {
  fs::path file = path;
  if (fs::is_directory(path)) {
    file = releaseIn(path);
    if (file.empty()) {
      throw core::InputError({.file = path}, "holds no cause-effect graph: neither root_node.xml nor data.json.",
                             "Give the folder of the node files, the repository, or the JSON file.");
    }
  }
  const std::string text = core::readFile(file);
  const std::size_t begin = text.starts_with("\xef\xbb\xbf") ? 3 : 0;
  const std::size_t first = text.find_first_not_of(" \t\r\n", begin);
  if (first == std::string::npos) {
    throw core::InputError({.file = file}, "is empty; a cause-effect graph was expected.", "Copy the file again.");
  }
  if (text[first] != '<') return readJsonRelease(file);
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (!fs::is_regular_file(folder / "root_node.xml")) {
    throw core::InputError({.file = file}, "is one file of an XML release, but there is no root_node.xml beside it.",
                           "Give the folder that holds all files of the release.");
  }
  return readXmlRelease(folder);
}

/// Nodes that are kept although no chain leads to them.
void reportOrphans(const Graph& graph, std::vector<Finding>& findings) {
  for (const std::size_t i : graph.orphans()) {
    const Node& node = graph.node(i);
    const bool has_hint = graph.find(node.placement_parent).has_value();
    findings.push_back({Severity::Warning, node.file, node.line, node.id,
                        "'" + node.title + "' is on no chain, since no phenomenon leads to it; it was kept.",
                        has_hint ? "Attach it to " + node.placement_parent + ", as its placementParentId says."
                                 : "Attach it to an effect, or remove it."});
  }
}

void reportDoubledTitles(const Graph& graph, std::vector<Finding>& findings) {
  std::unordered_map<std::string, std::string> first;
  for (const Node& node : graph.nodes()) {
    if (node.title.empty()) {
      findings.push_back({Severity::Warning, node.file, node.line, node.id, "the node has no title.", "Give it one."});
      continue;
    }
    const auto [other, is_new] = first.emplace(node.title, node.id);
    if (is_new) continue;
    findings.push_back({Severity::Warning, node.file, node.line, node.id,
                        "the title '" + node.title + "' is also that of node " + other->second + ".",
                        "Tell the two apart; releases are compared by title."});
  }
}

/// Makes one new edge at a time, since two placement hints together could form a circle.
Graph attachOrphansWherePlaced(Graph graph, std::vector<Finding>& findings) {
  for (const std::size_t i : graph.orphans()) {
    const auto parent = graph.find(graph.node(i).placement_parent);
    if (!parent || *parent == i || !graph.parents(i).empty()) continue;
    GraphData data = graph.data();
    data.edges.push_back({*parent, i});
    try {
      graph = Graph(std::move(data));
    } catch (const core::InputError&) {
      continue;  // its placement parent is one of its own causes; it stays an orphan and is reported as such
    }
    const Node& node = graph.node(i);
    findings.push_back({Severity::Note, node.file, node.line, node.id,
                        "was attached to " + node.placement_parent + ", as its placementParentId says.", ""});
  }
  return graph;
}

/// Folders and file names that say nothing about the tree.
bool isGeneric(const std::string& name) {
  static constexpr std::array<std::string_view, 11> kGeneric{"",       "data",  "src", "xml", "json", "main",
                                                             "master", "graph", ".",   "..",  "tree"};
  return std::find(kGeneric.begin(), kGeneric.end(), name) != kGeneric.end() || name.ends_with("_node") ||
         name.find_first_not_of("0123456789.-_") == std::string::npos;
}

/// Cuts what belongs to the release, from the end: "-2022-10-14", "-xml", "_v2", "-main".
std::string withoutReleaseMark(std::string name) {
  static const std::regex mark("[-_. ](v?[0-9][0-9.]*|xml|json|main|master|release|data)$");
  std::smatch match;
  while (std::regex_search(name, match, mark)) name.resize(static_cast<std::size_t>(match.position()));
  return name;
}

}  // namespace

ReadGraph readGraph(const fs::path& path, const ReadOptions& options) {
  Release release = readRelease(path);
  release.data.tree = options.tree.empty() ? treeNameFor(path) : options.tree;
  ReadGraph result{Graph(std::move(release.data)), std::move(release.findings)};
  if (result.graph.phenomena().empty()) {
    throw core::InputError({.file = path}, "has no phenomenon, so no chain begins anywhere.",
                           "Leave the parents of at least one effect empty, or name one in root_node.xml.");
  }
  if (options.attach_orphans) result.graph = attachOrphansWherePlaced(std::move(result.graph), result.findings);
  reportOrphans(result.graph, result.findings);
  reportDoubledTitles(result.graph, result.findings);
  const std::vector<Finding> references = checkReferences(result.graph);
  result.findings.insert(result.findings.end(), references.begin(), references.end());
  return result;
}

std::string treeNameFor(const fs::path& path) {
  fs::path at = fs::absolute(path).lexically_normal();
  if (!at.has_filename()) at = at.parent_path();  // a trailing slash
  bool is_file = !fs::is_directory(at);
  while (at.has_filename()) {
    fs::path name = at.filename();
    if (is_file && name.extension() == ".gz") name = name.stem();
    if (is_file && (name.extension() == ".json" || name.extension() == ".xml")) name = name.stem();
    const std::string lower = core::lowerCase(name.string());
    const std::string stem = withoutReleaseMark(lower);
    if (!isGeneric(stem) && !isGeneric(lower)) return stem;
    is_file = false;
    at = at.parent_path();
  }
  return "graph";
}

}  // namespace percollect
