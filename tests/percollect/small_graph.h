#pragma once

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "percollect/graph.h"

namespace test_support {

/// A graph from a list of nodes ("e:" effect, "d:" design parameter, "s:" system-independent cause; the rest is id and
/// title) and edges by id. Phenomena are the effects without parents.
inline percollect::GraphData smallGraphData(const std::vector<std::string>& nodes,
                                            const std::vector<std::pair<std::string, std::string>>& edges,
                                            const std::string& tree = "small") {
  percollect::GraphData data;
  data.tree = tree;
  data.source = "small.json";
  const auto indexOf = [&](const std::string& id) {
    std::size_t i = 0;
    while (data.nodes.at(i).id != id) ++i;
    return i;
  };
  for (const std::string& word : nodes) {
    percollect::Node node;
    node.id = word.substr(2);
    node.title = node.id;
    node.kind = word[0] == 'e'   ? percollect::NodeKind::Effect
                : word[0] == 'd' ? percollect::NodeKind::DesignParameter
                                 : percollect::NodeKind::SystemIndependent;
    node.file = "small.json";
    node.line = static_cast<int>(data.nodes.size()) + 1;
    data.nodes.push_back(node);
  }
  std::vector<bool> has_parent(nodes.size(), false);
  for (const auto& [parent, child] : edges) {
    data.edges.push_back({indexOf(parent), indexOf(child)});
    has_parent[indexOf(child)] = true;
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!has_parent[i] && data.nodes[i].kind == percollect::NodeKind::Effect) data.phenomena.push_back(i);
  }
  return data;
}

inline percollect::Graph smallGraph(const std::vector<std::string>& nodes,
                                    const std::vector<std::pair<std::string, std::string>>& edges,
                                    const std::string& tree = "small") {
  return percollect::Graph(smallGraphData(nodes, edges, tree));
}

}  // namespace test_support
