#include "gap/chain.h"

#include <algorithm>
#include <deque>
#include <limits>

namespace gap {

std::vector<std::size_t> nodesOf(const percollect::Graph& graph, const std::string& effect,
                                 const std::vector<std::string>& node_ids) {
  const std::string tag = "fidelis-effect:" + effect;
  std::vector<std::size_t> nodes;
  for (std::size_t i = 0; i < graph.size(); ++i) {
    const auto& node = graph.node(i);
    const auto label = node.labels.find("fidelis-effect");
    if (std::find(node.tags.begin(), node.tags.end(), tag) != node.tags.end() ||
        (label != node.labels.end() && label->second == effect)) {
      nodes.push_back(i);
    }
  }
  if (!nodes.empty() || graph.tree().find("lidarlimbs") == std::string::npos) return nodes;
  for (const std::string& id : node_ids) {
    if (const auto found = graph.find(id)) nodes.push_back(*found);
  }
  return nodes;
}

CauseChain chainOf(const percollect::Graph& graph, const std::string& effect,
                   const std::vector<std::string>& node_ids) {
  constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> came_from(graph.size(), kNone);
  std::vector<bool> seen(graph.size(), false);
  std::deque<std::size_t> open;
  for (const std::size_t node : nodesOf(graph, effect, node_ids)) {
    open.push_back(node);
    seen[node] = true;
  }
  const auto& phenomena = graph.phenomena();
  while (!open.empty()) {
    const std::size_t node = open.front();
    open.pop_front();
    if (std::find(phenomena.begin(), phenomena.end(), node) != phenomena.end()) {
      CauseChain chain;
      for (std::size_t at = node; at != kNone; at = came_from[at]) {
        chain.ids.push_back(graph.node(at).id);
        chain.titles.push_back(graph.node(at).title);
      }
      std::reverse(chain.ids.begin(), chain.ids.end());
      std::reverse(chain.titles.begin(), chain.titles.end());
      return chain;
    }
    for (const std::size_t parent : graph.parents(node)) {
      if (seen[parent]) continue;
      seen[parent] = true;
      came_from[parent] = node;
      open.push_back(parent);
    }
  }
  return {};
}

void addChains(Diagnosis& diagnosis, const percollect::Graph& graph) {
  for (Cause& cause : diagnosis.causes) {
    if (cause.kind != CauseKind::kEffect) continue;
    const CauseChain chain = chainOf(graph, cause.name, cause.percollect);
    cause.chain = chain.ids;
    cause.chain_titles = chain.titles;
  }
}

}  // namespace gap
