#include "app/desktop/visible_graph.h"

#include <algorithm>

#include "percollect/chains.h"

namespace desktop {

namespace {

/// Which nodes may be drawn at all, before folding.
std::vector<bool> candidates(const percollect::Graph& graph, const GraphFilter& filter) {
  std::vector<bool> may(graph.size(), !filter.only_through);
  if (filter.only_through) {
    const auto chains = percollect::chainsThrough(graph, *filter.only_through);
    for (const std::size_t node : chains.causes) may[node] = true;
    for (const std::size_t node : chains.effects) may[node] = true;
    may[*filter.only_through] = true;
  }
  for (std::size_t node = 0; node < graph.size(); ++node) {
    const bool is_cause = graph.node(node).kind != percollect::NodeKind::Effect;
    if (is_cause && !filter.causes && !filter.revealed.count(node) && node != filter.only_through) may[node] = false;
  }
  return may;
}

}  // namespace

VisibleGraph visiblePart(const percollect::Graph& graph, const GraphFilter& filter) {
  const std::vector<bool> may = candidates(graph, filter);
  std::vector<bool> visible(graph.size(), false);
  for (const std::size_t phenomenon : graph.phenomena()) {
    visible[phenomenon] = may[phenomenon] && (filter.phenomena.empty() || filter.phenomena.count(phenomenon));
  }
  VisibleGraph part;
  for (const std::size_t node : graph.parentsFirst()) {
    if (!visible[node]) continue;
    part.nodes.push_back(node);
    if (filter.folded.count(node)) continue;
    for (const std::size_t child : graph.children(node)) visible[child] = visible[child] || may[child];
  }
  for (const std::size_t node : part.nodes) {
    const auto children = graph.children(node);
    part.hidden.push_back(std::size_t(std::ranges::count_if(children, [&](std::size_t c) { return !visible[c]; })));
  }
  for (const percollect::Edge& edge : graph.edges()) {
    if (visible[edge.parent] && visible[edge.child]) part.edges.push_back(edge);
  }
  return part;
}

void reveal(const percollect::Graph& graph, std::size_t node, GraphFilter& filter) {
  const auto shown = [&] {
    const VisibleGraph part = visiblePart(graph, filter);
    return std::ranges::find(part.nodes, node) != part.nodes.end();
  };
  if (shown()) return;
  filter.revealed.insert(node);
  if (shown()) return;
  filter.only_through.reset();
  if (shown()) return;
  for (const std::size_t effect : percollect::chainsThrough(graph, node).effects) filter.folded.erase(effect);
  if (shown()) return;
  filter.phenomena.clear();
  if (shown()) return;
  filter.causes = true;  // the way to it leads over another cause
}

}  // namespace desktop
