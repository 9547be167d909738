#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "percollect/graph.h"

namespace percollect {

/// Where a chain that begins at a phenomenon ends. Causes may have causes of their own, so the two differ.
enum class ChainEnd {
  Leaf,      ///< at a node without children
  AnyCause,  ///< at every design parameter or system-independent cause on the way, and at leaves
};

/// A number of chains; there can be exponentially many.
struct ChainCount {
  std::uint64_t value = 0;
  bool saturated = false;  ///< true: at least `value`, which is the largest 64-bit number

  bool operator==(const ChainCount&) const = default;
};

/// What `fidelis import` prints. Only nodes that a phenomenon reaches are counted.
struct GraphCounts {
  std::size_t nodes = 0;
  std::size_t edges = 0;
  std::size_t phenomena = 0;
  std::size_t leaves = 0;
  std::size_t effects = 0;
  std::size_t design_parameters = 0;
  std::size_t system_independent = 0;
  std::size_t longest_path = 0;  ///< in edges, from a phenomenon
  ChainCount chains;             ///< that end at leaves

  bool operator==(const GraphCounts&) const = default;
};
[[nodiscard]] GraphCounts countGraph(const Graph& graph);

/// Which chains are meant. The default: all of them, from every phenomenon to every leaf.
struct ChainSelection {
  ChainEnd end = ChainEnd::Leaf;
  std::optional<std::size_t> phenomenon;  ///< only chains that begin here (any node may be given)
  std::optional<std::size_t> through;     ///< only chains that contain this node
};

/// By dynamic programming: linear in the edges, however many chains there are.
[[nodiscard]] ChainCount countChains(const Graph& graph, const ChainSelection& selection = {});

/// Visits chains one by one, depth first, children in their order; nothing is stored. The nodes are valid during the
/// call only. `visit` returns false to stop. The first `skip` chains are passed over without walking them, so a page
/// in the middle of millions costs no more than the first.
void eachChain(const Graph& graph, const ChainSelection& selection,
               const std::function<bool(std::span<const std::size_t> chain)>& visit, std::uint64_t skip = 0);

/// What lies on any chain through a node: what a drawing highlights.
struct Neighbourhood {
  std::vector<std::size_t> causes;   ///< all below, without the node; ascending
  std::vector<std::size_t> effects;  ///< all above, without the node; ascending
  std::vector<Edge> edges;           ///< those on a chain through the node, in the graph's order
};
[[nodiscard]] Neighbourhood chainsThrough(const Graph& graph, std::size_t node);

}  // namespace percollect
