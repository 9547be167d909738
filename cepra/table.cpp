#include "cepra/table.h"

#include <algorithm>
#include <limits>
#include <unordered_map>

#include "core/error.h"
#include "core/file.h"

namespace cepra {

using percollect::Graph;
using percollect::NodeKind;

namespace {

constexpr std::size_t kKeyDigits = 12;

/// Walks the paths over effects and makes a row wherever one ends.
class Builder {
 public:
  explicit Builder(const Graph& graph) : graph_(graph), effects_below_(graph.size()), causes_(graph.size()) {
    for (std::size_t i = 0; i < graph.size(); ++i) {
      for (const std::size_t child : graph.children(i)) {
        const percollect::Node& node = graph.node(child);
        if (node.kind == NodeKind::Effect) {
          effects_below_[i].push_back(child);
        } else {
          causes_[i].push_back({node.id, node.title, node.kind});
        }
      }
    }
  }

  Table build() {
    table_.tree = graph_.tree();
    table_.graph_sha256 = graph_.data().sha256;
    for (const std::size_t phenomenon : graph_.phenomena()) walkFrom(phenomenon);
    return std::move(table_);
  }

  [[nodiscard]] bool endsAt(std::size_t i) const { return !causes_[i].empty() || effects_below_[i].empty(); }
  [[nodiscard]] const std::vector<std::size_t>& effectsBelow(std::size_t i) const { return effects_below_[i]; }

 private:
  /// Depth first with an explicit stack: paths may be long.
  void walkFrom(std::size_t phenomenon) {
    if (graph_.node(phenomenon).kind != NodeKind::Effect) return;
    std::vector<std::size_t> path{phenomenon};
    std::vector<std::size_t> next_child{0};
    addRow(path);
    while (!path.empty()) {
      const auto& below = effects_below_[path.back()];
      if (next_child.back() == below.size()) {
        path.pop_back();
        next_child.pop_back();
        continue;
      }
      path.push_back(below[next_child.back()++]);
      next_child.push_back(0);
      addRow(path);
    }
  }

  void addRow(const std::vector<std::size_t>& path) {
    if (!endsAt(path.back())) return;
    Row row;
    std::vector<std::string> ids;
    for (const std::size_t i : path) {
      row.effects.push_back({graph_.node(i).id, graph_.node(i).title});
      ids.push_back(graph_.node(i).id);
    }
    row.causes = causes_[path.back()];
    row.key = rowKey(graph_.tree(), ids);
    const auto [other, is_new] = rows_by_key_.emplace(row.key, table_.rows.size());
    if (!is_new) {
      throw core::InputError({.file = graph_.data().source, .item = "row " + row.key},
                             "two paths have the same key: to '" + row.lastEffect().title + "' and to '" +
                                 table_.rows[other->second].lastEffect().title + "'.",
                             "Import the graph under another tree name.");
    }
    table_.rows.push_back(std::move(row));
  }

  const Graph& graph_;
  std::vector<std::vector<std::size_t>> effects_below_;
  std::vector<std::vector<Cause>> causes_;
  std::unordered_map<std::string, std::size_t> rows_by_key_;
  Table table_;
};

}  // namespace

std::optional<int> Row::relevance() const {
  if (!isScored()) return std::nullopt;
  return *occurrence.value + *impact.value;
}

std::vector<Cause> Row::causesOfKind(NodeKind kind) const {
  std::vector<Cause> list;
  std::copy_if(causes.begin(), causes.end(), std::back_inserter(list), [&](const Cause& c) { return c.kind == kind; });
  return list;
}

const Row* Table::find(std::string_view key) const {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return row.key == key; });
  return found == rows.end() ? nullptr : &*found;
}

std::string rowKey(std::string_view tree, std::span<const std::string> effect_ids) {
  std::string identity(tree);
  for (const std::string& id : effect_ids) {
    identity += '\0';  // cannot occur in an id, so {"a", "b"} and {"ab"} differ
    identity += id;
  }
  return "r" + core::sha256(identity).substr(0, kKeyDigits);
}

Table buildTable(const Graph& graph) { return Builder(graph).build(); }

std::size_t countRows(const Graph& graph) {
  constexpr std::size_t kMost = std::numeric_limits<std::size_t>::max();
  const auto saturatingSum = [](std::size_t a, std::size_t b) { return a > kMost - b ? kMost : a + b; };
  const Builder builder(graph);
  std::vector<std::size_t> rows(graph.size(), 0);
  const auto order = graph.parentsFirst();
  for (auto i = order.rbegin(); i != order.rend(); ++i) {
    rows[*i] = builder.endsAt(*i) ? 1 : 0;
    for (const std::size_t effect : builder.effectsBelow(*i)) rows[*i] = saturatingSum(rows[*i], rows[effect]);
  }
  std::size_t sum = 0;
  for (const std::size_t phenomenon : graph.phenomena()) {
    if (graph.node(phenomenon).kind == NodeKind::Effect) sum = saturatingSum(sum, rows[phenomenon]);
  }
  return sum;
}

}  // namespace cepra
