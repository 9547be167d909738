#include "specs/import_graph.h"

#include <set>

#include "cepra/merge.h"
#include "core/error.h"

namespace specs {

namespace {

/// Links from suspect rows become suspect themselves: whoever reads the requirement sees it there.
std::vector<Link> markLinks(ProjectStore& store, const std::vector<std::string>& rows, const Signature& by) {
  const std::set<std::string> suspect(rows.begin(), rows.end());
  std::vector<Link> marked;
  for (Link link : store.links()) {
    if (link.suspect || !suspect.count(link.from)) continue;
    link.suspect = true;
    store.link(link, by);
    marked.push_back(link);
  }
  return marked;
}

std::set<std::string> linkedKeys(const ProjectStore& store) {
  std::set<std::string> keys;
  for (const Link& link : store.links()) keys.insert(link.from);  // requirements among them do no harm
  return keys;
}

}  // namespace

ImportedGraph importGraph(ProjectStore& store, const percollect::Graph& graph, const Signature& by) {
  ImportedGraph result;
  store.inOneAction([&] {
    const auto before = store.graph();
    cepra::Table fresh = cepra::buildTable(graph);
    result.first = !before;
    if (before && before->tree() != graph.tree()) {
      throw core::InputError(
          {.file = store.file()}, "the project holds the graph '" + before->tree() + "', not '" + graph.tree() + "'.",
          "Use a project of its own, or say with --tree that this is a later release of '" + before->tree() + "'.");
    }
    if (before && before->data().sha256 == graph.data().sha256 && percollect::sameContent(*before, graph)) {
      result.unchanged = true;
      result.rows = store.cepra().rows.size();
      return;
    }
    if (before) {
      result.difference = percollect::difference(*before, graph);
      cepra::Merge merge = cepra::merge(store.cepra(), std::move(fresh), linkedKeys(store));
      fresh = std::move(merge.table);
      result.suspect = std::move(merge.suspect);
      result.added = std::move(merge.added);
      result.dropped = std::move(merge.dropped);
    }
    store.saveGraph(graph, by);
    store.saveCepra(fresh, by);
    result.rows = fresh.rows.size();
    result.suspect_links = markLinks(store, result.suspect, by);
  });
  return result;
}

}  // namespace specs
