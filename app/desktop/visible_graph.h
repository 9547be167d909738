#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <vector>

#include "percollect/graph.h"

namespace desktop {

/// What a person chose to see of a graph.
struct GraphFilter {
  std::set<std::size_t> phenomena;          ///< chains begin here; empty: at all phenomena
  bool causes = true;                       ///< false: effects only
  std::set<std::size_t> folded;             ///< nothing is shown for the sake of these nodes
  std::set<std::size_t> revealed;           ///< shown although `causes` is off (found by search)
  std::optional<std::size_t> only_through;  ///< only chains that contain this node
};

/// The part of a graph that is drawn.
struct VisibleGraph {
  std::vector<std::size_t> nodes;       ///< parents before children
  std::vector<percollect::Edge> edges;  ///< between visible nodes, as indices into the graph
  std::vector<std::size_t> hidden;      ///< for each of `nodes`: how many direct causes are not shown
};

/// Linear in the edges.
[[nodiscard]] VisibleGraph visiblePart(const percollect::Graph& graph, const GraphFilter& filter);

/// Changes the filter as little as needed so that the node is visible.
void reveal(const percollect::Graph& graph, std::size_t node, GraphFilter& filter);

}  // namespace desktop
