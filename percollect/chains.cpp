#include "percollect/chains.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace percollect {

namespace {

constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();

/// a + b, or "at least the largest number". Overflow is the only source of saturation.
ChainCount operator+(ChainCount a, ChainCount b) {
  if (a.saturated || b.saturated || a.value > kMost - b.value) return {kMost, true};
  return {a.value + b.value, false};
}

/// For every node the number of selected chains that go on from it, once for chains that have yet to meet the node
/// `through` and once for chains that have met it (or need not).
class CountsBelow {
 public:
  CountsBelow(const Graph& graph, const ChainSelection& selection)
      : graph_(graph), selection_(selection), free_(graph.size()), bound_(graph.size()) {
    const auto order = graph.parentsFirst();
    for (auto i = order.rbegin(); i != order.rend(); ++i) {
      if (endsAt(*i)) free_[*i].value = 1;
      for (const std::size_t child : graph.children(*i)) {
        free_[*i] = free_[*i] + free_[child];
        bound_[*i] = bound_[*i] + bound_[child];
      }
      if (selection.through == *i) bound_[*i] = free_[*i];
    }
  }

  [[nodiscard]] bool endsAt(std::size_t node) const {
    if (graph_.children(node).empty()) return true;
    return selection_.end == ChainEnd::AnyCause && graph_.node(node).kind != NodeKind::Effect;
  }
  [[nodiscard]] ChainCount from(std::size_t node, bool met) const { return met ? free_[node] : bound_[node]; }
  [[nodiscard]] bool meets(std::size_t node) const { return selection_.through == node; }
  [[nodiscard]] bool metFromTheStart() const { return !selection_.through.has_value(); }

  [[nodiscard]] std::vector<std::size_t> starts() const {
    if (selection_.phenomenon) return {*selection_.phenomenon};
    return graph_.phenomena();
  }

 private:
  const Graph& graph_;
  const ChainSelection& selection_;
  std::vector<ChainCount> free_;
  std::vector<ChainCount> bound_;
};

/// Depth-first walk with its own stack, so that a long path cannot exhaust the program's.
class Walk {
 public:
  Walk(const Graph& graph, const CountsBelow& counts, const std::function<bool(std::span<const std::size_t>)>& visit,
       std::uint64_t skip)
      : graph_(graph), counts_(counts), visit_(visit), skip_(skip) {}

  /// False: the visitor asked to stop.
  bool from(std::size_t start) {
    if (!enter(start, counts_.metFromTheStart())) return true;
    while (!steps_.empty()) {
      if (steps_.back().at_end && !arrive()) return false;
      const std::size_t node = chain_.back();
      const auto children = graph_.children(node);
      if (steps_.back().next_child == children.size()) {
        steps_.pop_back();
        chain_.pop_back();
        continue;
      }
      enter(children[steps_.back().next_child++], steps_.back().met);
    }
    return true;
  }

 private:
  struct Step {
    std::size_t next_child = 0;
    bool met = false;
    bool at_end = false;  ///< a chain that ends here has not been visited yet
  };

  /// Goes down to `node` unless nothing selected lies there or all of it is to be skipped.
  bool enter(std::size_t node, bool met) {
    const ChainCount below = counts_.from(node, met);
    if (below.value == 0) return false;
    if (!below.saturated && skip_ >= below.value) {
      skip_ -= below.value;
      return false;
    }
    const bool met_here = met || counts_.meets(node);
    chain_.push_back(node);
    steps_.push_back({.met = met_here, .at_end = met_here && counts_.endsAt(node)});
    return true;
  }

  bool arrive() {
    steps_.back().at_end = false;
    if (skip_ > 0) {
      --skip_;
      return true;
    }
    return visit_(chain_);
  }

  const Graph& graph_;
  const CountsBelow& counts_;
  const std::function<bool(std::span<const std::size_t>)>& visit_;
  std::uint64_t skip_;
  std::vector<std::size_t> chain_;
  std::vector<Step> steps_;
};

std::size_t longestPath(const Graph& graph) {
  std::vector<std::size_t> depth(graph.size(), 0);
  std::size_t longest = 0;
  for (const std::size_t i : graph.parentsFirst()) {
    if (!graph.isReachable(i)) continue;
    longest = std::max(longest, depth[i]);
    for (const std::size_t child : graph.children(i)) depth[child] = std::max(depth[child], depth[i] + 1);
  }
  return longest;
}

/// Marks `start` and everything that `next` leads to.
template <typename Next>
std::vector<bool> spread(std::size_t size, std::size_t start, Next next) {
  std::vector<bool> marked(size, false);
  std::vector<std::size_t> open{start};
  marked[start] = true;
  while (!open.empty()) {
    const std::size_t at = open.back();
    open.pop_back();
    for (const std::size_t other : next(at)) {
      if (marked[other]) continue;
      marked[other] = true;
      open.push_back(other);
    }
  }
  return marked;
}

}  // namespace

GraphCounts countGraph(const Graph& graph) {
  GraphCounts counts;
  counts.phenomena = graph.phenomena().size();
  for (std::size_t i = 0; i < graph.size(); ++i) {
    if (!graph.isReachable(i)) continue;
    ++counts.nodes;
    counts.edges += graph.children(i).size();
    counts.leaves += graph.children(i).empty() ? 1 : 0;
    switch (graph.node(i).kind) {
      case NodeKind::Effect:
        ++counts.effects;
        break;
      case NodeKind::DesignParameter:
        ++counts.design_parameters;
        break;
      case NodeKind::SystemIndependent:
        ++counts.system_independent;
        break;
    }
  }
  counts.longest_path = longestPath(graph);
  counts.chains = countChains(graph);
  return counts;
}

ChainCount countChains(const Graph& graph, const ChainSelection& selection) {
  const CountsBelow counts(graph, selection);
  ChainCount sum;
  for (const std::size_t start : counts.starts()) sum = sum + counts.from(start, counts.metFromTheStart());
  return sum;
}

void eachChain(const Graph& graph, const ChainSelection& selection,
               const std::function<bool(std::span<const std::size_t>)>& visit, std::uint64_t skip) {
  const CountsBelow counts(graph, selection);
  Walk walk(graph, counts, visit, skip);
  for (const std::size_t start : counts.starts()) {
    if (!walk.from(start)) return;
  }
}

Neighbourhood chainsThrough(const Graph& graph, std::size_t node) {
  const auto below = spread(graph.size(), node, [&](std::size_t i) { return graph.children(i); });
  auto above = spread(graph.size(), node, [&](std::size_t i) { return graph.parents(i); });
  if (graph.isReachable(node)) {  // an orphan has no chains; what leads to it is shown nevertheless
    for (std::size_t i = 0; i < graph.size(); ++i) above[i] = above[i] && graph.isReachable(i);
  }
  Neighbourhood around;
  for (std::size_t i = 0; i < graph.size(); ++i) {
    if (i == node) continue;
    if (below[i]) around.causes.push_back(i);
    if (above[i]) around.effects.push_back(i);
  }
  for (const Edge& edge : graph.edges()) {
    const bool is_above = above[edge.parent] && above[edge.child];
    const bool is_below = below[edge.parent] && below[edge.child];
    if (is_above || is_below) around.edges.push_back(edge);
  }
  return around;
}

}  // namespace percollect
