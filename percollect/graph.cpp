#include "percollect/graph.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include "core/error.h"
#include "core/text.h"

namespace percollect {

namespace {

core::Place placeOf(const Node& node) { return {.file = node.file, .line = node.line, .item = "node " + node.id}; }

/// The nodes of one cycle among the nodes that could not be sorted: follow parents that are themselves unsorted until
/// one comes again. Each unsorted node has such a parent.
std::vector<std::size_t> findCycle(const std::vector<std::vector<std::size_t>>& parents,
                                   const std::vector<bool>& sorted, std::size_t start) {
  std::vector<std::size_t> path;
  std::size_t at = start;
  while (std::find(path.begin(), path.end(), at) == path.end()) {
    path.push_back(at);
    at = *std::find_if(parents[at].begin(), parents[at].end(), [&](std::size_t p) { return !sorted[p]; });
  }
  path.erase(path.begin(), std::find(path.begin(), path.end(), at));
  std::reverse(path.begin(), path.end());  // now in the direction effect -> cause
  std::rotate(path.begin(), std::min_element(path.begin(), path.end()), path.end());
  return path;
}

}  // namespace

std::string_view toString(NodeKind kind) {
  switch (kind) {
    case NodeKind::Effect:
      return "effect";
    case NodeKind::DesignParameter:
      return "designParameter";
    case NodeKind::SystemIndependent:
      return "systemIndependent";
  }
  return "";
}

std::optional<NodeKind> nodeKindOf(std::string_view word) {
  for (const NodeKind kind : {NodeKind::Effect, NodeKind::DesignParameter, NodeKind::SystemIndependent}) {
    if (core::lowerCase(word) == core::lowerCase(toString(kind))) return kind;
  }
  return std::nullopt;
}

bool sameContent(const Node& a, const Node& b) {
  return a.id == b.id && a.title == b.title && a.kind == b.kind && a.block == b.block &&
         a.description == b.description && a.tags == b.tags && a.labels == b.labels && a.extra == b.extra &&
         a.references_text == b.references_text && a.references == b.references &&
         a.placement_parent == b.placement_parent;
}

Graph::Graph(GraphData data) : data_(std::move(data)) {
  indexNodes();
  connect();
  sortParentsFirst();
  markReachable();
}

void Graph::indexNodes() {
  for (std::size_t i = 0; i < data_.nodes.size(); ++i) {
    const Node& node = data_.nodes[i];
    if (node.id.empty()) {
      throw core::InputError({.file = node.file, .line = node.line}, "the node '" + node.title + "' has an empty id.",
                             "Give it an id that no other node has.");
    }
    const auto [first, is_new] = index_.emplace(node.id, i);
    if (is_new) continue;
    const Node& other = data_.nodes[first->second];
    throw core::InputError(placeOf(node),
                           "the id is used twice; '" + other.title + "' (" +
                               core::toString({.file = other.file.filename(), .line = other.line}) +
                               ") has it already.",
                           "Give one of the two another id, and adapt the nodes that refer to it.");
  }
}

void Graph::connect() {
  children_.resize(size());
  parents_.resize(size());
  std::set<std::pair<std::size_t, std::size_t>> known;
  for (const Edge& edge : data_.edges) {
    if (edge.parent >= size() || edge.child >= size()) {
      throw core::InputError({.file = data_.source}, "an edge leads to a node that does not exist.",
                             "Remove the edge together with its node.");
    }
    const Node& child = node(edge.child);
    if (edge.parent == edge.child) {
      throw core::InputError(placeOf(child), "the node is its own cause.", "Remove the edge from the node to itself.");
    }
    if (!known.emplace(edge.parent, edge.child).second) {
      throw core::InputError(placeOf(child), "the edge to its effect " + node(edge.parent).id + " is given twice.",
                             "Remove one of the two.");
    }
    children_[edge.parent].push_back(edge.child);
    parents_[edge.child].push_back(edge.parent);
  }
  std::set<std::size_t> phenomena;
  for (const std::size_t phenomenon : data_.phenomena) {
    if (phenomenon >= size() || !phenomena.insert(phenomenon).second) {
      throw core::InputError({.file = data_.source}, "a phenomenon is no node or is given twice.",
                             "Name each phenomenon once.");
    }
  }
}

void Graph::sortParentsFirst() {
  std::vector<std::size_t> waiting(size());
  std::vector<bool> sorted(size(), false);
  for (std::size_t i = 0; i < size(); ++i) {
    waiting[i] = parents_[i].size();
    if (waiting[i] == 0) order_.push_back(i);
  }
  for (std::size_t next = 0; next < order_.size(); ++next) {
    sorted[order_[next]] = true;
    for (const std::size_t child : children_[order_[next]]) {
      if (--waiting[child] == 0) order_.push_back(child);
    }
  }
  if (order_.size() == size()) return;
  const auto start = static_cast<std::size_t>(std::find(sorted.begin(), sorted.end(), false) - sorted.begin());
  const std::vector<std::size_t> cycle = findCycle(parents_, sorted, start);
  std::string text;
  for (const std::size_t i : cycle) text += node(i).id + " -> ";
  throw core::InputError(placeOf(node(cycle.front())),
                         "the node causes itself in a circle: " + text + node(cycle.front()).id + ".",
                         "Remove one of these edges; a cause-effect graph has no cycles.");
}

void Graph::markReachable() {
  reachable_.assign(size(), false);
  for (const std::size_t phenomenon : data_.phenomena) reachable_[phenomenon] = true;
  for (const std::size_t i : order_) {
    if (!reachable_[i]) continue;
    for (const std::size_t child : children_[i]) reachable_[child] = true;
  }
}

std::optional<std::size_t> Graph::find(std::string_view id) const {
  const auto found = index_.find(std::string(id));
  return found == index_.end() ? std::nullopt : std::optional(found->second);
}

std::size_t Graph::indexOf(std::string_view id) const {
  if (const auto index = find(id)) return *index;
  std::vector<std::string> ids;
  for (const Node& node : data_.nodes) ids.push_back(node.id);
  const std::string nearest = core::nearestName(id, ids);
  throw core::InputError({.file = data_.source, .item = "node " + std::string(id)},
                         "the tree '" + tree() + "' has no node with this id.",
                         nearest.empty() ? "Look the id up in the graph." : "Did you mean '" + nearest + "'?");
}

std::optional<std::size_t> Graph::findTitle(std::string_view title) const {
  for (std::size_t i = 0; i < size(); ++i) {
    if (data_.nodes[i].title == title) return i;
  }
  return std::nullopt;
}

std::span<const std::size_t> Graph::children(std::size_t index) const { return children_.at(index); }
std::span<const std::size_t> Graph::parents(std::size_t index) const { return parents_.at(index); }

std::vector<std::size_t> Graph::orphans() const {
  std::vector<std::size_t> list;
  for (std::size_t i = 0; i < size(); ++i) {
    if (!reachable_[i]) list.push_back(i);
  }
  return list;
}

bool sameContent(const Graph& a, const Graph& b) {
  if (a.tree() != b.tree() || a.size() != b.size() || a.phenomena() != b.phenomena()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!sameContent(a.node(i), b.node(i))) return false;
    if (!std::ranges::equal(a.children(i), b.children(i))) return false;
  }
  return true;
}

}  // namespace percollect
