#pragma once

#include <string_view>
#include <vector>

#include "percollect/finding.h"
#include "percollect/graph.h"

namespace percollect {

/// Parses `[parent, author, title, url, note][...]` (JSON) and `[parent, url, note] ...` (XML). Authors, titles and
/// notes may contain commas, and the last bracket may be missing; so the address is the first field that begins with
/// http, everything between it and the parent is author and title, everything behind it is the note.
[[nodiscard]] std::vector<Reference> parseReferences(std::string_view text);

/// Notes on references that fit no edge: an unknown parent, a node that is no parent, an edge without any reference,
/// text outside of brackets, a missing last bracket.
[[nodiscard]] std::vector<Finding> checkReferences(const Graph& graph);

}  // namespace percollect
