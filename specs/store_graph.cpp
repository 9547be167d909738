// The imported cause-effect graph in a project file.

#include "core/error.h"
#include "specs/connection.h"

namespace specs {

namespace {

using percollect::GraphData;
using percollect::Node;

std::int64_t number(std::size_t value) { return static_cast<std::int64_t>(value); }

void storeNode(ProjectStore::Connection& connection, std::size_t position, const Node& node, const Value& phenomenon) {
  connection.run("INSERT INTO graph_node VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
                 {number(position), node.id, node.title, std::string(percollect::toString(node.kind)), node.block,
                  node.description, node.references_text, node.placement_parent, node.file.string(),
                  std::int64_t{node.line}, phenomenon});
  for (std::size_t i = 0; i < node.tags.size(); ++i) {
    connection.run("INSERT INTO graph_tag VALUES (?, ?, ?)", {number(position), number(i), node.tags[i]});
  }
  for (const auto* values : {&node.labels, &node.extra}) {
    for (const auto& [key, value] : *values) {
      connection.run("INSERT INTO graph_value VALUES (?, ?, ?, ?)",
                     {number(position), key, std::int64_t{values == &node.extra}, value});
    }
  }
  for (std::size_t i = 0; i < node.references.size(); ++i) {
    const percollect::Reference& reference = node.references[i];
    connection.run("INSERT INTO graph_reference VALUES (?, ?, ?, ?, ?, ?, ?, ?)",
                   {number(position), number(i), reference.parent, reference.author, reference.title, reference.url,
                    reference.note, reference.raw});
  }
}

void loadNodes(const ProjectStore::Connection& connection, GraphData& data) {
  connection.each(
      "SELECT id, title, kind, block, description, references_text, placement_parent, file, line FROM graph_node "
      "ORDER BY position",
      {}, [&](const Record& record) {
        Node& node = data.nodes.emplace_back();
        node.id = record.text(0);
        node.title = record.text(1);
        node.kind = percollect::nodeKindOf(record.text(2)).value_or(percollect::NodeKind::Effect);
        node.block = record.text(3);
        node.description = record.text(4);
        node.references_text = record.text(5);
        node.placement_parent = record.text(6);
        node.file = record.text(7);
        node.line = static_cast<int>(record.integer(8));
      });
  const auto nodeOf = [&](const Record& record) -> Node& {
    return data.nodes.at(static_cast<std::size_t>(record.integer(0)));
  };
  connection.each("SELECT node, tag FROM graph_tag ORDER BY node, position", {},
                  [&](const Record& record) { nodeOf(record).tags.push_back(record.text(1)); });
  connection.each("SELECT node, is_json, name, value FROM graph_value", {}, [&](const Record& record) {
    Node& node = nodeOf(record);
    (record.integer(1) ? node.extra : node.labels)[record.text(2)] = record.text(3);
  });
  connection.each("SELECT node, parent, author, title, url, note, raw FROM graph_reference ORDER BY node, position", {},
                  [&](const Record& record) {
                    nodeOf(record).references.push_back({.parent = record.text(1),
                                                         .author = record.text(2),
                                                         .title = record.text(3),
                                                         .url = record.text(4),
                                                         .note = record.text(5),
                                                         .raw = record.text(6)});
                  });
}

}  // namespace

void ProjectStore::saveGraph(const percollect::Graph& graph, const Signature& by) {
  connection_->action([&] {
    connection_->run("DELETE FROM graph_node");  // with all that hangs on it
    const GraphData& data = graph.data();
    connection_->run("INSERT OR REPLACE INTO graph VALUES (1, ?, ?, ?, ?, ?)",
                     {data.tree, data.source.string(), data.sha256, by.who, by.when});
    std::map<std::size_t, std::size_t> phenomena;
    for (std::size_t i = 0; i < data.phenomena.size(); ++i) phenomena[data.phenomena[i]] = i;
    for (std::size_t i = 0; i < data.nodes.size(); ++i) {
      const auto place = phenomena.find(i);
      storeNode(*connection_, i, data.nodes[i],
                place == phenomena.end() ? Value(nullptr) : Value(number(place->second)));
    }
    for (std::size_t i = 0; i < data.edges.size(); ++i) {
      connection_->run("INSERT INTO graph_edge VALUES (?, ?, ?)",
                       {number(i), number(data.edges[i].parent), number(data.edges[i].child)});
    }
    connection_->record("graph", "graph", by, "imported " + data.source.string() + ", sha256 " + data.sha256);
  });
}

std::optional<percollect::Graph> ProjectStore::graph() const {
  std::optional<GraphData> data;
  connection_->snapshot([&] {
    const auto import = graphImport();
    if (!import) return;
    data.emplace();
    data->tree = import->tree;
    data->source = import->source;
    data->sha256 = import->sha256;
    loadNodes(*connection_, *data);
    connection_->each("SELECT parent, child FROM graph_edge ORDER BY position", {}, [&](const Record& record) {
      data->edges.push_back({static_cast<std::size_t>(record.integer(0)), static_cast<std::size_t>(record.integer(1))});
    });
    connection_->each(
        "SELECT position FROM graph_node WHERE phenomenon IS NOT NULL ORDER BY phenomenon", {},
        [&](const Record& record) { data->phenomena.push_back(static_cast<std::size_t>(record.integer(0))); });
  });
  if (!data) return std::nullopt;
  return percollect::Graph(std::move(*data));
}

std::optional<GraphImport> ProjectStore::graphImport() const {
  std::optional<GraphImport> import;
  connection_->each("SELECT tree, source, sha256, who, imported FROM graph", {}, [&](const Record& record) {
    import = GraphImport{.tree = record.text(0),
                         .source = record.text(1),
                         .sha256 = record.text(2),
                         .who = record.text(3),
                         .when = record.text(4)};
  });
  return import;
}

}  // namespace specs
