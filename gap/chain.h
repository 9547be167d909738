#pragma once

#include <string>
#include <vector>

#include "gap/diagnosis.h"
#include "percollect/graph.h"

namespace gap {

/// The way from a cause up to its phenomenon.
struct CauseChain {
  std::vector<std::string> ids;  ///< the cause's node first
  std::vector<std::string> titles;
};

/// The nodes of a graph that stand for an effect. A node belongs to it by its tag "fidelis-effect:<name>", or else, in
/// a graph of the tree "lidarlimbs", by the ids of the effect's declaration.
[[nodiscard]] std::vector<std::size_t> nodesOf(const percollect::Graph& graph, const std::string& effect,
                                               const std::vector<std::string>& node_ids);

/// The shortest chain from the nodes of an effect to a phenomenon of the graph; empty if the graph has none of them.
[[nodiscard]] CauseChain chainOf(const percollect::Graph& graph, const std::string& effect,
                                 const std::vector<std::string>& node_ids);

/// Fills the chains of all effects among the causes.
void addChains(Diagnosis& diagnosis, const percollect::Graph& graph);

}  // namespace gap
