#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace percollect {

enum class NodeKind {
  Effect,             ///< something that happens inside the perception chain
  DesignParameter,    ///< a cause that the sensor's maker chooses
  SystemIndependent,  ///< a cause that comes from outside the sensor
};

/// "effect", "designParameter", "systemIndependent": the words of the JSON release.
[[nodiscard]] std::string_view toString(NodeKind kind);
[[nodiscard]] std::optional<NodeKind> nodeKindOf(std::string_view word);  // ignores case

/// Literature behind one edge: `[parent, author, title, url, note]`, `[parent, url, note]` in the XML release.
struct Reference {
  std::string parent;  ///< id of the effect to which the edge leads
  std::string author;
  std::string title;
  std::string url;
  std::string note;
  std::string raw;  ///< the group as written, without its brackets

  bool operator==(const Reference&) const = default;
};

/// One node as written by its authors; nothing of it is lost.
struct Node {
  std::string id;  ///< unique within its tree only
  std::string title;
  NodeKind kind = NodeKind::Effect;
  std::string block;  ///< decomposition block, e.g. "Signal propagation"
  std::string description;
  std::vector<std::string> tags;              ///< synonyms for search
  std::map<std::string, std::string> labels;  ///< further texts by key, e.g. FMCWspecific, scenarioEntity
  std::map<std::string, std::string> extra;   ///< further values that are no texts, as JSON
  std::string references_text;                ///< as written; `references` is parsed from it
  std::vector<Reference> references;
  std::string placement_parent;  ///< drawing hint of the XML release; no edge follows from it

  std::filesystem::path file;  ///< where it was read
  int line = 0;
};

/// Equal in everything but the place where they were read.
[[nodiscard]] bool sameContent(const Node& a, const Node& b);

/// From an effect to one of its causes; indices into the nodes.
struct Edge {
  std::size_t parent = 0;  ///< the effect
  std::size_t child = 0;   ///< what causes it

  bool operator==(const Edge&) const = default;
};

/// Everything that makes a graph, as plain values: to store, to load, to edit.
struct GraphData {
  std::string tree;                    ///< name of the tree through all its releases, e.g. "lidarlimbs"
  std::filesystem::path source;        ///< file or folder that was read
  std::string sha256;                  ///< of the file; of names and contents of all node files for XML
  std::vector<Node> nodes;             ///< in the order of the file; file names in natural order for XML
  std::vector<Edge> edges;             ///< their order gives the order of children and of parents
  std::vector<std::size_t> phenomena;  ///< where chains begin; a node without parents need not be one (orphans)
};

/// A cause-effect graph: directed, without cycles, many parents per node allowed.
///
///     phenomenon ──► effect ──► effect ──► cause      parent ──► child: "is caused by"
///              └───► effect ─────┘
///
/// Immutable; to edit, change a copy of data() and build a new graph.
/// Source: Linnhoff et al. 2021, ITSC (PerCollECT), tuprints 18949.
class Graph {
 public:
  Graph() = default;

  /// Throws InputError, with the place of the node: a doubled or empty id, an edge to nowhere or to itself, a doubled
  /// edge, a cycle (its nodes are listed).
  explicit Graph(GraphData data);

  [[nodiscard]] const GraphData& data() const noexcept { return data_; }
  [[nodiscard]] const std::string& tree() const noexcept { return data_.tree; }
  [[nodiscard]] const std::vector<Node>& nodes() const noexcept { return data_.nodes; }
  [[nodiscard]] const Node& node(std::size_t index) const { return data_.nodes.at(index); }
  [[nodiscard]] std::size_t size() const noexcept { return data_.nodes.size(); }
  [[nodiscard]] const std::vector<Edge>& edges() const noexcept { return data_.edges; }
  [[nodiscard]] const std::vector<std::size_t>& phenomena() const noexcept { return data_.phenomena; }

  [[nodiscard]] std::optional<std::size_t> find(std::string_view id) const;
  /// Throws InputError that names the nearest id.
  [[nodiscard]] std::size_t indexOf(std::string_view id) const;
  [[nodiscard]] std::optional<std::size_t> findTitle(std::string_view title) const;  ///< the first with this title
  [[nodiscard]] std::span<const std::size_t> children(std::size_t index) const;      ///< its direct causes
  [[nodiscard]] std::span<const std::size_t> parents(std::size_t index) const;       ///< its direct effects

  /// All nodes, each one after all of its parents.
  [[nodiscard]] std::span<const std::size_t> parentsFirst() const noexcept { return order_; }
  [[nodiscard]] bool isReachable(std::size_t index) const { return reachable_.at(index); }  ///< from a phenomenon
  [[nodiscard]] std::vector<std::size_t> orphans() const;                                   ///< unreachable nodes

 private:
  void indexNodes();
  void connect();
  void sortParentsFirst();
  void markReachable();

  GraphData data_;
  std::unordered_map<std::string, std::size_t> index_;
  std::vector<std::vector<std::size_t>> children_;
  std::vector<std::vector<std::size_t>> parents_;
  std::vector<std::size_t> order_;
  std::vector<bool> reachable_;
};

/// Same tree name, same nodes and phenomena in the same order, same children in the same order. Source, hash and places
/// do not count.
[[nodiscard]] bool sameContent(const Graph& a, const Graph& b);

}  // namespace percollect
