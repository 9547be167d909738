#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "percollect/graph.h"

namespace percollect {

enum class ChangeKind {
  Added,
  Removed,
  Renumbered,  ///< same title, other id
  Renamed,     ///< same id, a title that is only a little different
  Reparented,
  KindChanged,
  BlockChanged,
  DescriptionChanged,
  ReferencesChanged,
  TagsChanged,
  LabelsChanged,  ///< labels, extra values or the placement hint
};

[[nodiscard]] std::string_view toString(ChangeKind kind);  // "added", "re-parented", ...

/// One change of one node. A node may have several.
struct NodeChange {
  ChangeKind kind = ChangeKind::Added;
  std::string old_id;  ///< empty for Added
  std::string new_id;  ///< empty for Removed
  std::string title;   ///< in the new release; the old one for Removed
  std::string text;    ///< one sentence with the old and the new value
};

struct Difference {
  std::vector<NodeChange> changes;             ///< removed ones first, then in the order of the new release
  std::map<std::string, std::string> new_ids;  ///< old id -> new id of every node that is in both releases

  [[nodiscard]] bool empty() const noexcept { return changes.empty(); }
};

/// What happened to a tree between two releases. Ids are not stable between releases and titles are edited, so nodes
/// are matched by id and title, then by title alone, then by id if the titles resemble each other; an id that now means
/// something else counts as one node removed and one added.
[[nodiscard]] Difference difference(const Graph& before, const Graph& after);

}  // namespace percollect
